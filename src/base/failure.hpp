#pragma once
// What went wrong, for the caller: the exit status of the program or of the C interface, and the messages.
#include <string>
#include <vector>

namespace ehl::program {

struct Failure {
  int status = 0;  ///< one of ExitStatus
  std::vector<std::string> messages{};
};

/// The failure that belongs to the exception being handled. Call it inside a catch block.
Failure current_failure();

}  // namespace ehl::program
