#pragma once
// A program under a time limit: an end by a signal and an end by the clock are told from an exit status.
#include <string>
#include <vector>

namespace hard {

struct Finished {
  int status = -1;       ///< exit status; -1 where it did not end by itself
  int signal = 0;        ///< that ended it; 0: none
  bool hung = false;     ///< still running at the end of the time limit, and killed
  double seconds = 0.0;  ///< of processor time
  std::string out{};
  std::string err{};
};

/// Runs words[0] with the other words as arguments in a folder, where it leaves its output in the files `out` and
/// `err`. in: environment, NAME=value, added to that of this process; limit [s of processor time], ten times as long on
/// the clock. Safe to call from several threads. errors: std::system_error when the program cannot be started.
Finished run_program(const std::vector<std::string>& words, const std::string& folder,
                     const std::vector<std::string>& environment, double limit);

}  // namespace hard
