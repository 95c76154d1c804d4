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

constexpr std::size_t largest_deck = 1 << 20;  // bytes; somebody named a result or a device
constexpr std::size_t most_broken_lines = 20;  // listed; a file with more of them is hardly a deck

struct Line {
  enum class Kind { blank, heading, assignment, broken };
  Kind kind = Kind::blank;
  std::string text;   // what the library gets to read
  std::string error;  // of a broken line
};

Line classify(const std::string& raw) {
  const std::string text = trimmed(raw.substr(0, raw.find('#')));
  if (text.empty() || text[0] == ';') return {};
  if (text[0] == '[') {
    const std::string name = trimmed(text.substr(1, text.find(']') - 1));
    if (text.back() != ']' || text.find(']') != text.size() - 1)
      // The library still gets the heading, so that one slip is not reported again for every key below it.
      return {Line::Kind::broken, "[" + name + "]",
              quoted(text) + " is no heading: write [" + quotable(name) + "] alone on a line"};
    if (name.empty()) return {Line::Kind::broken, "", "a section heading without a name"};
    return {Line::Kind::heading, "[" + name + "]", ""};
  }
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    return {Line::Kind::broken, "", quoted(text) + " is neither [section] nor key = value: an = is missing"};
  if (trimmed(text.substr(0, equals)).empty())
    return {Line::Kind::broken, "", quoted(text) + ": the name of the key is missing before the ="};
  return {Line::Kind::assignment, text, ""};
}

// Every key is announced to the library, so that its own notion of a registered name is the catalogue's.
options::options_description describe(const Catalogue& catalogue) {
  options::options_description description;
  for (const Key& key : catalogue.keys)
    description.add_options()((key.section + "." + key.name).c_str(), options::value<std::string>(),
                              key.meaning.c_str());
  return description;
}

}  // namespace

std::string load_text(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw core::InputError(path + ": there is no such file: give the path of a deck (`ehl keys --deck` writes one)");
  if (status.type() == std::filesystem::file_type::directory)
    throw core::InputError(path + ": this is a directory: give the path of a deck file inside it");

  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::InputError(path + ": cannot be read: " + std::strerror(errno));
  std::string text;
  for (char piece[4096]; file && text.size() <= largest_deck;) {
    file.read(piece, sizeof piece);
    text.append(piece, static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw core::InputError(path + ": cannot be read: " + std::strerror(errno));
  if (text.size() > largest_deck) throw core::InputError(path + ": larger than a megabyte: this is no deck");
  if (text.find('\0') != std::string::npos) throw core::InputError(path + ": not a text file: this is no deck");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return c <= ' '; }))
    throw core::InputError(path + ": the deck is empty (`ehl keys --deck` writes a complete one)");
  return text;
}

Document parse(const std::string& text, const std::string& name, const Catalogue& catalogue) {
  // The library reads the values but forgets the lines. So the lines are told apart here, broken ones listed and
  // left out, and the n-th assignment that the library returns is the n-th assignment line.
  Document document;
  document.name = name;
  std::vector<std::string> places;
  std::string readable;
  std::istringstream lines(text);
  int number = 0;
  std::size_t broken = 0;
  for (std::string raw; std::getline(lines, raw);) {
    const std::string place = name + ":" + std::to_string(++number);
    const Line line = classify(raw);
    if (line.kind == Line::Kind::broken && ++broken <= most_broken_lines)
      document.errors.push_back(place + ": " + line.error);
    if (line.kind == Line::Kind::heading)
      document.headings.push_back({line.text.substr(1, line.text.size() - 2), place});
    if (line.kind == Line::Kind::assignment) places.push_back(place);
    readable += line.text + "\n";
  }
  if (broken > most_broken_lines)
    document.errors.push_back(name + ": " + std::to_string(broken - most_broken_lines) +
                              " more lines cannot be read: is this a deck?");

  std::istringstream stream(readable);
  options::parsed_options parsed(nullptr);
  try {
    parsed = options::parse_config_file(stream, describe(catalogue), /*allow_unregistered=*/true);
  } catch (const options::error& error) {
    document.errors.push_back(name + ": " + error.what());
    return document;
  }
  if (parsed.options.size() != places.size()) throw std::logic_error("deck: lines and assignments do not match");
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& option = parsed.options[k];
    // A name may contain a dot, a section may not: the last heading above the line decides, and the library has
    // put it in front of the first dot.
    const std::size_t dot = option.string_key.find('.');
    const std::string section = dot == std::string::npos ? "" : option.string_key.substr(0, dot);
    const std::string key = dot == std::string::npos ? option.string_key : option.string_key.substr(dot + 1);
    document.assignments.push_back(
        {section, key, option.value.empty() ? "" : trimmed(option.value.front()), places[k]});
  }
  return document;
}

Assignment parse_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0 || dot + 1 == equals)
    throw core::InputError("command line: --set " + quotable(text) +
                           ": write section.key=value, e.g. --set grid.cells=512");
  return {trimmed(text.substr(0, dot)), trimmed(text.substr(dot + 1, equals - dot - 1)),
          trimmed(text.substr(equals + 1)), "command line"};
}

}  // namespace ehl::deck
