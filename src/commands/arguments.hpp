#pragma once
// The command line: what a command takes, and what was given.
#include <map>
#include <string>
#include <vector>

namespace ehl::program {

/// What was given.
struct Arguments {
  std::string command{};
  std::vector<std::string> operands{};
  std::map<std::string, std::vector<std::string>> options{};

  bool has(const std::string& name) const { return options.contains(name); }
  /// The value of an option that may be given once.
  std::string value(const std::string& name, const std::string& otherwise) const;
  /// All values of an option that may be repeated.
  std::vector<std::string> values(const std::string& name) const;
  /// What --unset and --set make of the deck, as deck::read() takes it.
  std::vector<std::string> overrides() const;
};

struct Option {
  std::string name{};      ///< without the dashes
  std::string argument{};  ///< name of its value; empty: a flag
  std::string meaning{};
  bool repeated = false;  ///< may be given more than once
};

struct Command {
  std::string name{};
  std::string operands{};  ///< one word each, between brackets what may be left out, with dots what may be several:
                           ///< "DECK", "[COMMAND]", "TABLE..."
  std::string meaning{};
  std::vector<Option> options{};
  int (*function)(const Arguments& arguments) = nullptr;  ///< gives the exit status
};

/// Throws core::InputError: "command line: " and the message.
[[noreturn]] void refuse(const std::string& message);

/// ": did you mean plot?", or the end of the sentence where no candidate is near. in: what stands before the name,
/// "--".
std::string suggestion(const std::string& name, const std::vector<std::string>& candidates,
                       const std::string& before = "");

/// The command of this name. errors: core::InputError, with the nearest name.
const Command& find_command(const std::vector<Command>& commands, const std::string& name);

/// in: command, operands and options in any order. `--help` or `-h` among them becomes `help COMMAND`.
/// errors: core::InputError: unknown command or option (with the nearest), a value or an operand missing, too many.
Arguments parse_arguments(std::vector<std::string> words, const std::vector<Command>& commands);

/// The value of an option that takes a whole number; `otherwise` where it was not given.
/// errors: core::InputError: another value, or one below `least` or above `most`.
int whole_number(const Arguments& arguments, const std::string& name, int otherwise, int most, int least = 1);

/// The help of the program, or of one command. errors: core::InputError where it is unknown.
std::string help_text(const std::vector<Command>& commands, const std::string& command);

}  // namespace ehl::program
