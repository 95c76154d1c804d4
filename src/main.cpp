// The program: takes the command line apart, runs one command, and turns what went wrong into a message and a status.
#include <cstdio>
#include <exception>
#include <new>

#include "base/exit_status.hpp"
#include "base/signals.hpp"
#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "core/process.hpp"

namespace ehl::program {
namespace {

int guarded(const std::vector<std::string>& words) {
  try {
    const Arguments arguments = parse_arguments(words, commands());
    return find_command(commands(), arguments.command).function(arguments);
  } catch (const core::InputError& error) {
    for (const std::string& message : error.messages()) std::fprintf(stderr, "ehl: %s\n", message.c_str());
    return wrong_input;
  } catch (const core::FileError& error) {
    std::fprintf(stderr, "ehl: %s\n", error.what());
    return file_trouble;
  } catch (const core::SolverError& error) {
    std::fprintf(stderr, "ehl: not converged: %s\n", error.what());
    return not_converged;
  } catch (const core::Interrupted&) {
    std::fprintf(stderr, "ehl: interrupted: nothing was written\n");
    return interrupted;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "ehl: out of memory: take fewer cells (`ehl check` estimates the need)\n");
    return internal_failure;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ehl: internal failure: %s\n", error.what());
    return internal_failure;
  }
}

}  // namespace
}  // namespace ehl::program

int main(int count, char** words) {
  ehl::core::prepare_process(words);
  ehl::program::install_signal_handlers();
  return ehl::program::guarded({words + 1, words + count});
}
