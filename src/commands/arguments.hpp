#pragma once
// The command line: the options that a command accepts, and the options that were given.
#include <map>
#include <string>
#include <vector>

namespace ehl::program {

/// The command, operands and options that were given.
struct Arguments {
  std::string command{};
  std::vector<std::string> operands{};
  std::map<std::string, std::vector<std::string>> options{};

  bool has(const std::string& name) const { return options.contains(name); }
  /// The value of an option that may be given once; `otherwise` if it was not given.
  std::string value(const std::string& name, const std::string& otherwise) const;
  /// All values of an option that may be repeated.
  std::vector<std::string> values(const std::string& name) const;
  /// The changes of the deck by --unset and --set, in the form that deck::read() accepts.
  std::vector<std::string> overrides() const;
};

struct Option {
  std::string name{};      ///< without the dashes
  std::string argument{};  ///< the name of its value; empty: the option is a flag
  std::string meaning{};
  bool repeated = false;  ///< may be given more than once
};

struct Command {
  std::string name{};
  std::string operands{};  ///< the operands, one word each; brackets mark an operand that is optional, dots one that
                           ///< may be repeated: "DECK", "[COMMAND]", "TABLE..."
  std::string meaning{};
  std::vector<Option> options{};
  int (*function)(const Arguments& arguments) = nullptr;  ///< returns the exit status
};

/// Throws core::InputError: "command line: " and the message.
[[noreturn]] void refuse(const std::string& message);

/// ": did you mean plot?", or only the end of the sentence if no candidate is similar. in: before:
/// what precedes the name, "--".
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates,
                       const std::string& before = "");

/// The command with this name. errors: core::InputError with the nearest name.
const Command& find_command(const std::vector<Command>& commands, const std::string& name);

/// in: command, operands and options, in any order. If `--help` or `-h` is among them, the
/// command becomes `help COMMAND`.
/// errors: core::InputError for an unknown command or option (with the nearest), a missing value or
/// operand, or too many operands.
Arguments parse_arguments(std::vector<std::string> words, const std::vector<Command>& commands);

/// The value of an option that takes a whole number; `otherwise` if the option was not given.
/// errors: core::InputError for a value that is no whole number, or is below `least` or above `most`.
int whole_number(const Arguments& arguments, const std::string& name, int otherwise, int most, int least = 1);

/// The help of the program, or of one command. errors: core::InputError if the command is unknown.
std::string help_text(const std::vector<Command>& commands, const std::string& command);

}  // namespace ehl::program
