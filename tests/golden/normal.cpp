#include "golden/normal.hpp"

#include <cctype>
#include <regex>

namespace golden {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// The end of the number that begins at a digit.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  const auto digits = [&](std::size_t from) {
    while (from < text.size() && is_digit(text[from])) ++from;
    return from;
  };
  std::size_t end = digits(at);
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) end = digits(end + 1);
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+');
    const std::size_t exponent = end + (sign ? 2 : 1);
    if (exponent < text.size() && is_digit(text[exponent])) end = digits(exponent);
  }
  return end;
}

// True for a number that belongs to the words.
bool is_kept(const std::string& text, std::size_t begin, std::size_t end) {
  const auto at = [&](std::size_t k) { return k < text.size() ? text[k] : ' '; };
  const bool whole = text.find_first_of(".eE", begin) >= end;
  if (is_letter(at(end))) return true;
  if (!whole) return false;
  const bool unit = at(end) == '/' && is_letter(at(end + 1));
  const bool before_times = text.compare(end, 3, " x ") == 0 && is_digit(at(end + 3));
  const bool after_times = begin >= 4 && text.compare(begin - 3, 3, " x ") == 0 && is_digit(text[begin - 4]);
  const bool line = begin >= 2 && text[begin - 1] == ':' && is_letter(text[begin - 2]);
  return unit || before_times || after_times || line;
}

std::string without_numbers(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char before = at > 0 ? text[at - 1] : ' ';
    if (!is_digit(text[at]) || is_letter(before) || before == '^' || before == '\\') {
      // The rest of a word such as h5 or x^2 belongs to it.
      const bool in_word = is_digit(text[at]);
      out += text[at++];
      while (in_word && at < text.size() && is_digit(text[at])) out += text[at++];
      continue;
    }
    const std::size_t end = end_of_number(text, at);
    if (is_kept(text, at, end)) {
      out += text.substr(at, end - at);
    } else {
      const std::size_t size = out.size();
      const bool sign = size > 0 && (out.back() == '-' || out.back() == '+') &&
                        (size == 1 || std::string(" \t\n([{=,:\"").find(out[size - 2]) != std::string::npos);
      if (sign) out.pop_back();
      out += '#';
    }
    at = end;
  }
  return std::regex_replace(std::regex_replace(out, std::regex(" +#"), " #"), std::regex("# +"), "# ");
}

}  // namespace

std::string normal(std::string text, Numbers numbers, const std::vector<Place>& places) {
  for (const Place& place : places) replace_all(text, place.path, place.name);
  const std::pair<const char*, const char*> patterns[] = {
      {"[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]+Z", "DATE"},
      {"commit [0-9a-f]{12,40}( with changes|, with changes that no commit holds)?|commit unknown", "commit COMMIT"},
      {"g\\+\\+ [0-9][^,;\"\n]*", "COMPILER"},
      {"ehl [0-9.]+,", "ehl VERSION,"},
      {"COMPILER, [0-9a-f]{16}", "COMPILER, HASH"},
      {"machine: [^\n]*", "machine: MACHINE"},
      {"x86-64(-v[0-9])?", "LEVEL"},
      {"[0-9]+ threads?", "N threads"},
      {"ehl: +[0-9]+ %  [^\n]*\n", ""}};
  for (const auto& [pattern, name] : patterns) text = std::regex_replace(text, std::regex(pattern), name);
  if (numbers == Numbers::replaced) return without_numbers(text);
  return std::regex_replace(text, std::regex(" in [0-9.]+ s\\b"), " in # s");
}

}  // namespace golden
