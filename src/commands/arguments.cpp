#include "commands/arguments.hpp"

#include <algorithm>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

const CommandRecord& find_command(const std::vector<CommandRecord>& commands, const std::string& name) {
  std::vector<std::string> names;
  for (const CommandRecord& command : commands) {
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  const std::string near = deck::nearest(name, names);
  throw core::InputError("command line: unknown command '" + name + "'" +
                         (near.empty() ? "" : ": did you mean " + near + "?") + " Commands are " +
                         deck::joined(names, ", ") + " (`ehl help`)");
}

const OptionRecord& find_option(const CommandRecord& command, const std::string& name) {
  std::vector<std::string> names;
  for (const OptionRecord& option : command.options) {
    if (option.name == name) return option;
    names.push_back(option.name);
  }
  const std::string near = deck::nearest(name, names);
  throw core::InputError("command line: `ehl " + command.name + "` has no option --" + name +
                         (near.empty() ? "" : ": did you mean --" + near + "?") + " (`ehl help " + command.name + "`)");
}

std::string usage(const CommandRecord& command) {
  std::string text = "ehl " + command.name + (command.operands.empty() ? "" : " ") + command.operands;
  for (const OptionRecord& option : command.options)
    text += " [--" + option.name + (option.argument.empty() ? "" : " " + option.argument) + "]" +
            (option.repeated ? "..." : "");
  return text;
}

void check_operands(const CommandRecord& command, const Arguments& given) {
  const std::string said = "command line: `ehl " + command.name + "`: ";
  if (given.operands.size() < command.least)
    throw core::InputError(said + command.operands + " is missing. Usage: " + usage(command));
  if (given.operands.size() > command.most)
    throw core::InputError(said + "'" + given.operands[command.most] + "' is one too many. Usage: " + usage(command));
}

}  // namespace

std::string Arguments::value(const std::string& name, const std::string& otherwise) const {
  const auto found = options.find(name);
  return found == options.end() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::values(const std::string& name) const {
  const auto found = options.find(name);
  return found == options.end() ? std::vector<std::string>{} : found->second;
}

std::vector<CommandRecord> command_records() {
  const OptionRecord set{"set", "section.key=value", true, "overrides or adds a key of the deck"};
  const OptionRecord threads{"threads", "N", false, "number of threads (default: the cores this process may use)"};
  return {
      {"run",
       "DECK",
       1,
       1,
       "solves a case: table and summary on stdout, progress on stderr, result in an HDF5 file",
       {set,
        {"output", "FILE.h5", false, "result file (default: [output] file, else the name of the deck)"},
        {"overwrite", "", false, "replace an existing result file"},
        threads,
        {"profile", "", false, "adds where the time went, part by part"},
        {"json", "", false, "one JSON object on stdout and nothing else"},
        {"quiet", "", false, "no progress"}}},
      {"check",
       "DECK",
       1,
       1,
       "validates a deck and prints everything that follows from it; solves nothing",
       {set, threads}},
      {"resume",
       "FILE.h5",
       1,
       1,
       "goes on with a run in time from the checkpoint in its result file, and completes that file",
       {threads,
        {"profile", "", false, "adds where the time went, part by part"},
        {"json", "", false, "one JSON object on stdout and nothing else"},
        {"quiet", "", false, "no progress"}}},
      {"sweep",
       "DECK",
       1,
       1,
       "solves many cases of one deck, several at a time: one row per case in a CSV table. The same command again goes "
       "on "
       "where it was stopped",
       {{"vary", "section.key=LIST", true,
         "a key and its values: 2,5,10 or a:b:n or a:b:n:log or words; several --vary make all combinations, the first "
         "varies slowest"},
        set,
        {"output", "FILE.csv", false, "the table (default: name of the deck with _sweep.csv)"},
        {"overwrite", "", false, "begin the table anew"},
        {"threads", "N", false, "cases at a time, one thread each (default: the cores this process may use)"},
        {"quiet", "", false, "no progress"}}},
      {"study",
       "DECK",
       1,
       1,
       "what accuracy costs in time: the same case over levels, wedge schemes, film evaluators and cycles; error "
       "against seconds and work, as a table and a CSV file that `ehl plot` draws. A deck with [transient]: over the "
       "tolerance of the time integration, error over the run against seconds and steps",
       {{"levels", "a:b", false,
         "cells of the coarsest and of the finest grid, b = a times a power of two (default: from 64 up to the "
         "deck's)"},
        {"wedges", "LIST", false, "of upstream1,upstream2 (default: both)"},
        {"evaluators", "LIST", false, "of mlmi4,mlmi6,mlmi8,fft,direct (default: all; direct up to 20000 nodes)"},
        {"cycles", "LIST", false, "cycles per level, e.g. 1V,2W, or run: as `ehl run` does (default: 1V,2V,1W,2W,run)"},
        {"reference", "N", false,
         "cells of the grid that the reference is extrapolated from, with those below it (default: twice the finest)"},
        {"rtol", "LIST", false,
         "of a deck with [transient] and instead of all the above: the tolerances (default: 1e-2,1e-3,1e-4,1e-5,1e-6)"},
        set,
        {"output", "FILE.csv", false, "the table (default: name of the deck with _study.csv)"},
        {"overwrite", "", false, "replace an existing table"},
        {"repeat", "N", false, "solve everything N times and take the least time (default 3)"},
        {"threads", "N", false, "number of threads of each solution (default 1)"},
        {"jobs", "N", false, "solutions at a time (default 1); with more the times are marked as shared"},
        {"quiet", "", false, "no progress"}}},
      {"extract",
       "FILE.h5 DATASET",
       2,
       2,
       "prints a dataset of a result as columns: P, H, levels, history, summary, scales, deck, or a path in the file",
       {{"along", "x|y", false, "only the section of a field along this axis"},
        {"at", "y=0|x=0", false, "where the section lies: the nearest grid line is taken (default 0)"},
        {"step", "K", false, "number K, from 0, of fields at several times or depths; without it a section of all"},
        {"matrix", "", false, "a field as a matrix with its axes, for gnuplot's `matrix nonuniform`"}}},
      {"plot",
       "FILE.h5|FILE.csv",
       1,
       1,
       "draws the figures of postprocess/ from a result or the table of a sweep or a study, beside it",
       {{"figure", "NAME", true, "only this figure"},
        {"format", "png|svg|pdf", false, "format of the pictures (default png)"}}},
      {"keys",
       "[SECTION[.KEY]]",
       0,
       1,
       "lists the keys of the deck: default, unit, range, meaning, source",
       {{"deck", "", false, "a complete commented deck instead"}}},
  };
}

Arguments parse_arguments(const std::vector<std::string>& words, const std::vector<CommandRecord>& commands) {
  Arguments given;
  if (words.empty()) throw core::InputError("command line: a command is missing\n" + help(commands, ""));
  const CommandRecord& command = find_command(commands, words[0]);
  given.command = command.name;
  bool only_operands = false;  // after "--"
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (only_operands || word.size() < 2 || word[0] != '-') {
      given.operands.push_back(word);
      continue;
    }
    if (word == "--") {
      only_operands = true;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::size_t dashes = word.starts_with("--") ? 2 : 1;
    const std::string name = word.substr(dashes, equals == std::string::npos ? equals : equals - dashes);
    const OptionRecord& option = find_option(command, name);
    std::string value;
    if (option.argument.empty()) {
      if (equals != std::string::npos)
        throw core::InputError("command line: " + word + ": --" + name + " takes no value");
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (k + 1 < words.size()) {
      value = words[++k];
    } else {
      throw core::InputError("command line: --" + name + ": the value is missing: " + option.argument);
    }
    if (given.has(name) && !option.repeated) throw core::InputError("command line: --" + name + " is given twice");
    given.options[name].push_back(value);
  }
  check_operands(command, given);
  return given;
}

int whole_number(const Arguments& arguments, const std::string& name, int otherwise, int most) {
  if (!arguments.has(name)) return otherwise;
  const std::string text = arguments.value(name, "");
  const deck::ReadNumber read = deck::read_number(text);
  const bool good = read.status == deck::ReadNumber::Status::number && read.value >= 1.0 && read.value <= most &&
                    read.value == static_cast<int>(read.value);
  if (!good)
    throw core::InputError("command line: --" + name + " " + text +
                           ": must be a whole number >= 1 and <= " + std::to_string(most));
  return static_cast<int>(read.value);
}

std::string help(const std::vector<CommandRecord>& commands, const std::string& name) {
  if (!name.empty()) {
    const CommandRecord& command = find_command(commands, name);
    std::string text = "usage: " + usage(command) + "\n\n" + command.meaning + "\n";
    for (const OptionRecord& option : command.options)
      text += "\n  --" + option.name + (option.argument.empty() ? "" : " " + option.argument) + "\n      " +
              option.meaning + "\n";
    return text;
  }
  std::string text = "ehl: elastohydrodynamically lubricated contacts by multilevel methods\n\n";
  for (const CommandRecord& command : commands) text += "  " + usage(command) + "\n      " + command.meaning + "\n";
  text +=
      "  ehl help [COMMAND]\n  ehl version\n\nexit status: 0 solved, 1 internal failure, 2 wrong input, 3 not "
      "converged, "
      "4 a file could not be read or written,\n130 interrupted\n";
  return text;
}

}  // namespace ehl::program
