#include "deck/document.hpp"

#include <algorithm>
#include <boost/program_options/errors.hpp>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

namespace options = boost::program_options;

constexpr std::size_t largest_deck = 1 << 20;  // bytes; a larger file is probably a result or a device
constexpr std::size_t most_broken_lines = 20;  // number listed; a file with more of them is hardly a deck

// Parses one line that is neither blank nor a comment. returns what is wrong with it; empty if nothing is.
std::string read_line(const std::string& line, const std::string& place, std::string& section, Document& document) {
  if (line[0] == '[') {
    const std::size_t end = line.find(']');
    const std::string name = trimmed(line.substr(1, end - 1));
    if (end + 1 == line.size() && name.empty()) return "a section heading without a name";
    section = name;  // also for a broken heading, so that the keys below it are not reported
    if (end + 1 != line.size())
      return quoted(line) + " is not a heading: write [" + quotable(name) + "] alone on a line";
    document.headings.push_back({section, place});
    return {};
  }
  // The library stops at the first line that it cannot read, so it gets the lines one by one.
  std::istringstream stream(line);
  try {
    const auto read = options::parse_config_file(stream, {}, /*allow_unregistered=*/true).options.front();
    if (read.string_key.empty()) return quoted(line) + ": the name of the key is missing before the =";
    document.assignments.push_back({section, read.string_key, trimmed(read.value.front()), place});
  } catch (const options::invalid_config_file_syntax&) {
    return quoted(line) + " is neither [section] nor key = value: an = is missing";
  }
  return {};
}

}  // namespace

std::string load_text(const std::string& path) {
  if (has_control_character(path))
    throw core::InputError(quoted(path) + ": the name of a deck must not contain control characters: rename it");
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw core::InputError(path + ": there is no such file: give the path of a deck (`ehl keys --deck` writes one)");
  if (status.type() == std::filesystem::file_type::directory)
    throw core::InputError(path + ": this is a directory: give the path of a deck file inside it");
  if (status.type() == std::filesystem::file_type::fifo || status.type() == std::filesystem::file_type::socket)
    throw core::InputError(path + ": this is a pipe, but a deck may be read more than once: give the path of a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::InputError(path + ": cannot be read: " + std::strerror(errno));
  std::string text;
  for (char piece[4096]; file && text.size() <= largest_deck;) {
    file.read(piece, sizeof piece);
    text.append(piece, static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw core::InputError(path + ": cannot be read: " + std::strerror(errno));
  if (text.size() > largest_deck) throw core::InputError(path + ": larger than a megabyte: this is not a deck");
  if (text.find('\0') != std::string::npos) throw core::InputError(path + ": not a text file: this is not a deck");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return c <= ' '; }))
    throw core::InputError(path + ": the deck is empty (`ehl keys --deck` writes a complete one)");
  return text;
}

Document parse(const std::string& text, const std::string& name) {
  Document document{.name = name};
  std::string section;
  std::istringstream lines(text);
  int number = 0;
  std::size_t broken = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = name + ":" + std::to_string(++number);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty() || line[0] == ';') continue;
    const std::string wrong = read_line(line, place, section, document);
    if (!wrong.empty() && ++broken <= most_broken_lines) document.errors.push_back(place + ": " + wrong);
  }
  if (broken > most_broken_lines)
    document.errors.push_back(name + ": " + std::to_string(broken - most_broken_lines) +
                              " more lines cannot be read: is this a deck?");
  return document;
}

Assignment parse_override(const std::string& text) {
  if (text.starts_with('-')) {
    const std::size_t dot = text.find('.');
    if (dot == std::string::npos || text.find('=') != std::string::npos)
      throw core::InputError("command line: --unset " + quotable(text.substr(1)) +
                             ": write section.key, e.g. --unset grid.cells");
    return {.section = trimmed(text.substr(1, dot - 1)),
            .name = trimmed(text.substr(dot + 1)),
            .place = on_command_line,
            .removes = true};
  }
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0 || dot + 1 == equals)
    throw core::InputError("command line: --set " + quotable(text) +
                           ": write section.key=value, e.g. --set grid.cells=512");
  if (has_control_character(text))
    throw core::InputError("command line: --set " + quotable(text) + ": must not contain control characters");
  return {trimmed(text.substr(0, dot)), trimmed(text.substr(dot + 1, equals - dot - 1)),
          trimmed(text.substr(equals + 1)), on_command_line};
}

}  // namespace ehl::deck
