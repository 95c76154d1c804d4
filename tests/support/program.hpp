#pragma once
// Runs the built program as a user does.
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace support {

struct Ended {
  int status = -1;  ///< exit status; 128 + signal if a signal ended the program
  std::string out;
  std::string err;

  /// True if the messages contain all of the parts.
  bool says(const std::vector<std::string>& parts) const {
    for (const std::string& part : parts)
      if (err.find(part) == std::string::npos) return false;
    return true;
  }
};

/// Runs a command line in the shell, in the folder, and captures stdout and stderr.
inline Ended shell(const TemporaryFolder& folder, const std::string& command) {
  const TemporaryFolder caught;
  const std::string line = "cd '" + folder.path() + "' && { " + command + "\n} >'" + (caught / "out") + "' 2>'" +
                           (caught / "err") + "' </dev/null";
  const int raw = std::system(line.c_str());
  Ended ended;
  ended.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  ended.out = caught.read("out");
  ended.err = caught.read("err");
  return ended;
}

/// Shell: waits until the program with the number $p handles signals, however busy the machine is, or has ended. The
/// sixth digit from the right of the mask holds SIGXCPU, which is among the last.
inline const std::string until_it_handles_signals =
    "while [ -e /proc/$p ] && ! grep -q '^SigCgt:.*[89a-f].....$' /proc/$p/status; do sleep 0.02; done; sleep 0.1; ";

/// Runs the program with these arguments, which the shell parses.
inline Ended ehl(const TemporaryFolder& folder, const std::string& arguments) {
  return shell(folder, std::string("'") + EHL_PROGRAM + "' " + arguments);
}

}  // namespace support
