// The program: parses the command line, runs one command, and turns an error into a message and an exit status.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "base/failure.hpp"
#include "base/signals.hpp"
#include "commands/commands.hpp"
#include "core/process.hpp"
#include "results/read.hpp"

namespace ehl::program {
namespace {

int reported(const Failure& failure) {
  for (const std::string& message : failure.messages) std::fprintf(stderr, "ehl: %s\n", message.c_str());
  return failure.status;
}

// An exception in a thread of a parallel loop cannot leave that thread. Most of these exceptions mean that memory ran
// out.
[[noreturn]] void end_of_a_thread() {
  if (std::current_exception()) try {
      std::rethrow_exception(std::current_exception());
    } catch (...) {
      const int status = reported(current_failure());
      std::fflush(nullptr);
      std::_Exit(status);
    }
  std::abort();
}

int guarded(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words, commands());
    return find_command(commands(), arguments.command).function(arguments);
  } catch (...) {
    return reported(current_failure());
  }
}

}  // namespace
}  // namespace ehl::program

int main(int count, char** words) {
  ehl::core::prepare_process(words);
  ehl::results::run_no_hdf5_at_exit();
  ehl::program::install_signal_handlers();
  std::set_terminate(ehl::program::end_of_a_thread);
  return ehl::program::guarded({words + 1, words + count});
}
