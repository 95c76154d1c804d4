#include "commands/arguments.hpp"

#include <algorithm>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <sstream>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

namespace po = boost::program_options;

template <class Record>
const Record* find(const std::vector<Record>& records, const std::string& name) {
  const auto found = std::ranges::find(records, name, &Record::name);
  return found == records.end() ? nullptr : &*found;
}

template <class Record>
std::vector<std::string> names(const std::vector<Record>& records) {
  std::vector<std::string> all;
  for (const Record& record : records) all.push_back(record.name);
  return all;
}

po::options_description described(const Command& command) {
  po::options_description all("options");
  for (const Option& option : command.options)
    all.add_options()(option.name.c_str(),
                      option.argument.empty() ? static_cast<po::value_semantic*>(new po::untyped_value(true))
                                              : po::value<std::string>()->value_name(option.argument),
                      option.meaning.c_str());
  return all;
}

std::string usage(const Command& command) {
  std::string text = "ehl " + command.name + (command.operands.empty() ? "" : " ") + command.operands;
  for (const Option& option : command.options)
    text += " [--" + option.name + (option.argument.empty() ? "" : " " + option.argument) + "]" +
            (option.repeated ? "..." : "");
  return text;
}

void check_operands(const Command& command, const std::vector<std::string>& given) {
  const std::vector<std::string> wanted = deck::split_words(command.operands);
  const auto least = std::ranges::count_if(wanted, [](const std::string& word) { return !word.starts_with('['); });
  const std::string said = "`ehl " + command.name + "`: ";
  if (given.size() < static_cast<std::size_t>(least))
    refuse(said + command.operands + " is missing. Usage: " + usage(command));
  const bool more = !wanted.empty() && wanted.back().ends_with("...");
  if (given.size() > wanted.size() && !more)
    refuse(said + "'" + given[wanted.size()] + "' is one argument too many. Usage: " + usage(command));
}

// The name of an option without dashes and value, for both forms in which the library returns
// it: "--set" and "-sett=3".
std::string bare_name(const std::string& token) {
  const std::string name = token.substr(0, token.find('='));
  return name.substr(std::min(name.size(), name.find_first_not_of('-')));
}

po::parsed_options parsed(const Command& command, const std::vector<std::string>& words) try {
  using namespace po::command_line_style;
  // There are no short options: -x is an unknown option and not a file.
  constexpr int style = (unix_style & ~allow_guessing) | allow_long_disguise;
  return po::command_line_parser(words).options(described(command)).style(style).allow_unregistered().run();
} catch (const po::invalid_command_line_syntax& error) {
  const std::string name = bare_name(error.get_option_name());
  const Option* option = find(command.options, name);
  if (error.kind() == po::invalid_syntax::extra_parameter) refuse("--" + name + " takes no value");
  refuse("--" + name + ": the value is missing" + (option == nullptr ? "" : ": " + option->argument));
} catch (const po::error& error) {
  refuse(error.what());  // for instance "-=x"
}

// in: token, as typed: "--outptu=x", "-o".
[[noreturn]] void refuse_option(const Command& command, const std::string& token) {
  const std::string name = bare_name(token);
  const auto begins =
      std::ranges::find_if(command.options, [&](const Option& one) { return one.name.starts_with(name); });
  const std::string advice = name.size() == 1 && begins != command.options.end()
                                 ? ": did you mean --" + begins->name + "?"
                                 : suggestion(name, names(command.options), "--");
  refuse("`ehl " + command.name + "` has no option " + token.substr(0, token.find('=')) + advice + " See `ehl help " +
         command.name + "`");
}

}  // namespace

void refuse(const std::string& message) { throw core::InputError("command line: " + message); }

std::string Arguments::value(const std::string& name, const std::string& otherwise) const {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::values(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::vector<std::string>{} : found->second;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates, const std::string& before) {
  const std::string near = deck::nearest(name, candidates);
  return near.empty() ? "." : ": did you mean " + before + near + "?";
}

std::vector<std::string> Arguments::overrides() const {
  std::vector<std::string> all;
  for (const std::string& key : values("unset")) all.push_back("-" + key);
  for (const std::string& one : values("set")) all.push_back(one);
  return all;
}

const Command& find_command(const std::vector<Command>& commands, const std::string& name) {
  if (const Command* command = find(commands, name)) return *command;
  refuse("unknown command '" + name + "'" + suggestion(name, names(commands)) + " Commands are " +
         deck::joined(names(commands), ", ") + " (`ehl help`)");
}

Arguments parse_arguments(std::vector<std::string> words, const std::vector<Command>& commands) {
  if (words.empty()) refuse("a command is missing\n" + help_text(commands, ""));
  if (words[0].starts_with('-')) words[0] = words[0] == "-h" ? "help" : bare_name(words[0]);
  if (std::any_of(words.begin() + 1, words.end(), [](const auto& word) { return word == "--help" || word == "-h"; }))
    words = {"help", words[0]};
  const Command& command = find_command(commands, words[0]);
  words.erase(words.begin());
  Arguments given;
  given.command = command.name;
  for (const po::option& one : parsed(command, words).options) {
    if (one.position_key >= 0) {
      given.operands.insert(given.operands.end(), one.value.begin(), one.value.end());
      continue;
    }
    const std::string name = bare_name(one.unregistered ? one.original_tokens[0] : one.string_key);
    const Option* option = find(command.options, name);
    if (option == nullptr) refuse_option(command, one.original_tokens[0]);
    if (given.has(name) && !option->repeated) refuse("--" + name + " is given twice");
    given.options[name].push_back(one.value.empty() ? "" : one.value[0]);
  }
  check_operands(command, given.operands);
  return given;
}

int whole_number(const Arguments& arguments, const std::string& name, int otherwise, int most, int least) {
  if (!arguments.has(name)) return otherwise;
  const std::string text = arguments.value(name, "");
  const deck::ReadNumber read = deck::read_number(text);
  const bool good = read.status == deck::ReadNumber::Status::number && read.value >= least && read.value <= most &&
                    read.value == static_cast<int>(read.value);
  if (!good)
    refuse("--" + name + " " + text + ": must be a whole number >= " + std::to_string(least) +
           " and <= " + std::to_string(most));
  return static_cast<int>(read.value);
}

std::string help_text(const std::vector<Command>& commands, const std::string& name) {
  std::ostringstream text;
  if (name.empty()) {
    text << "ehl: elastohydrodynamically lubricated contacts by multilevel methods\n\n";
    for (const Command& command : commands) text << "  " << usage(command) << "\n      " << command.meaning << "\n";
    text << "\nexit status: 0 solved, 1 internal failure, 2 wrong input, 3 not converged, "
            "4 a file could not be read or written,\n130 interrupted\n";
    return text.str();
  }
  const Command& command = find_command(commands, name);
  text << "usage: " << usage(command) << "\n\n" << command.meaning << "\n";
  if (!command.options.empty()) text << "\n" << described(command);
  return text.str();
}

}  // namespace ehl::program
