// Texts that must show numbers only.
#include <regex>
#include <sstream>

#include "hard/judge.hpp"

namespace hard {

std::string no_number_in(const std::string& text) {
  static const std::regex word("(^|[^A-Za-z_])(nan|inf)($|[^A-Za-z_])");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, word)) return line;
  return {};
}

std::string without_pictures(std::string markup) {
  const std::string begin = "base64,";
  for (std::size_t at = markup.find(begin); at != std::string::npos; at = markup.find(begin, at + 1))
    markup.erase(at + begin.size(), markup.find_first_of("\"')", at) - at - begin.size());
  return markup;
}

}  // namespace hard
