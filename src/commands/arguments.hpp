#pragma once
// The command line: commands, their options, and what was given.
#include <map>
#include <string>
#include <vector>

namespace ehl::program {

struct OptionRecord {
  std::string name{};      ///< without the dashes
  std::string argument{};  ///< name of its value; empty: a flag
  bool repeated = false;   ///< may be given more than once
  std::string meaning{};
};

struct CommandRecord {
  std::string name{};
  std::string operands{};  ///< as in the usage line
  std::size_t least = 0;   ///< operands
  std::size_t most = 0;
  std::string meaning{};
  std::vector<OptionRecord> options{};
};

struct Arguments {
  std::string command{};
  std::vector<std::string> operands{};
  std::map<std::string, std::vector<std::string>> options{};

  bool has(const std::string& name) const { return options.contains(name); }
  /// The value of an option that may be given once.
  std::string value(const std::string& name, const std::string& otherwise) const;
  /// All values of an option that may be repeated.
  std::vector<std::string> values(const std::string& name) const;
};

/// All commands of this version.
std::vector<CommandRecord> command_records();

/// errors: core::InputError: unknown command or option (with the nearest), a value or an operand missing, too many.
Arguments parse_arguments(const std::vector<std::string>& words, const std::vector<CommandRecord>& commands);

/// The value of an option that takes a whole number >= 1; `otherwise` where it was not given.
/// errors: core::InputError: another value, or one above `most`.
int whole_number(const Arguments& arguments, const std::string& name, int otherwise, int most);

/// The help of the program, or of one command.
std::string help(const std::vector<CommandRecord>& commands, const std::string& command);

}  // namespace ehl::program
