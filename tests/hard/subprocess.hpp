#pragma once
// Runs a program with a time limit, and distinguishes an exit status from an end by a signal or by the limit.
#include <string>
#include <vector>

namespace hard {

struct Finished {
  int status = -1;       ///< exit status; -1 if the program did not end by itself
  int signal = 0;        ///< signal that ended the program; 0: none
  bool hung = false;     ///< the program reached the time limit and was killed
  double seconds = 0.0;  ///< processor time
  std::string out{};
  std::string err{};
};

/// Runs words[0] with the other words as arguments in a folder; its output goes to the files `out` and `err` there. in:
/// environment: NAME=value, added to that of this process; limit [s of processor time]; the wall-clock limit is ten
/// times as long. Several threads may call it at once. errors: std::system_error if the program cannot be started.
Finished run_program(const std::vector<std::string>& words, const std::string& folder,
                     const std::vector<std::string>& environment, double limit);

}  // namespace hard
