// The program: takes the command line apart, runs one command, and turns what went wrong into a message and a status.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "commands/commands.hpp"
#include "commands/exit_status.hpp"
#include "commands/signals.hpp"
#include "core/errors.hpp"
#include "core/process.hpp"
#include "core/processor_level.hpp"
#include "deck/text.hpp"
#include "report/version.hpp"

namespace ehl::program {
namespace {

int dispatch(const std::vector<std::string>& words) {
  const std::vector<CommandRecord> commands = command_records();
  const std::string first = words.empty() ? "" : words[0];
  if (first == "help" || first == "--help" || first == "-h") {
    print(help(commands, words.size() > 1 ? words[1] : ""));
    return solved;
  }
  if (first == "version" || first == "--version") {
    const Version built = version();
    print("ehl " + built.number + ", commit " + built.commit + (built.dirty ? " with changes" : "") + ", " +
          built.compiler + ", for " + core::processor_level() + "\n");
    return solved;
  }
  for (std::size_t k = 1; k < words.size(); ++k)
    if (words[k] == "--help" || words[k] == "-h") {
      print(help(commands, first));
      return solved;
    }
  const Arguments arguments = parse_arguments(words, commands);
  if (arguments.command == "run") return run(arguments);
  if (arguments.command == "check") return check(arguments);
  if (arguments.command == "resume") return resume(arguments);
  if (arguments.command == "sweep") return sweep(arguments);
  if (arguments.command == "study") return study(arguments);
  if (arguments.command == "extract") return extract(arguments);
  if (arguments.command == "plot") return plot(arguments);
  return keys(arguments);
}

int guarded(const std::vector<std::string>& words) {
  try {
    return dispatch(words);
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
