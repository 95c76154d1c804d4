// The program: takes the command line apart, runs one command, and turns what went wrong into a message and a status.
#include <cstdio>

#include "base/failure.hpp"
#include "base/signals.hpp"
#include "commands/commands.hpp"
#include "core/process.hpp"

namespace ehl::program {
namespace {

int guarded(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words, commands());
    return find_command(commands(), arguments.command).function(arguments);
  } catch (...) {
    const Failure failure = current_failure();
    for (const std::string& message : failure.messages) std::fprintf(stderr, "ehl: %s\n", message.c_str());
    return failure.status;
  }
}

}  // namespace
}  // namespace ehl::program

int main(int count, char** words) {
  ehl::core::prepare_process(words);
  ehl::program::install_signal_handlers();
  return ehl::program::guarded({words + 1, words + count});
}
