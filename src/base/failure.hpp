#pragma once
// What went wrong, for whoever called: the exit status of the program and of the C interface, and the messages.
#include <string>
#include <vector>

namespace ehl::program {

struct Failure {
  int status = 0;  ///< of ExitStatus
  std::vector<std::string> messages{};
};

/// Of the exception that is being handled: to be called in a catch block.
Failure current_failure();

}  // namespace ehl::program
