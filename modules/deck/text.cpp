#include "deck/text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace ehl::deck {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

}  // namespace

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\f\v";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) text += (k == 0 ? "" : separator) + parts[k];
  return text;
}

std::string quotable(const std::string& text) {
  constexpr std::size_t longest = 80;  // bytes: one line of a terminal
  std::size_t kept = text.size();
  if (kept > longest) {
    kept = longest;
    while (kept > 0 && (static_cast<unsigned char>(text[kept]) & 0xC0) == 0x80) --kept;  // no half UTF-8 character
  }
  std::string shown;
  for (const char c : text.substr(0, kept)) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= ' ' && code != 0x7f) {
      shown += c;
      continue;
    }
    constexpr std::string_view digits = "0123456789abcdef";
    shown += std::string("\\x") + digits[code / 16] + digits[code % 16];
  }
  if (kept < text.size()) shown += "... (" + std::to_string(text.size()) + " bytes)";
  return shown;
}

std::string quoted(const std::string& text) { return std::string("'").append(quotable(text)).append("'"); }

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (c != ',' && c != ' ' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}

std::string shortest(double value) {
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

std::uint64_t hash(std::string_view text, std::uint64_t before) {
  for (const char c : text) before = (before ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return before;
}

bool is_utf8(std::string_view text) {
  constexpr std::uint32_t first_of_length[] = {0, 0, 0x80, 0x800, 0x10000};  // overlong encodings are invalid
  constexpr std::uint32_t last = 0x10FFFF, surrogates = 0xD800, after_surrogates = 0xE000;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = lead < 0x80         ? 1
                               : lead >> 5 == 0x6  ? 2
                               : lead >> 4 == 0xE  ? 3
                               : lead >> 3 == 0x1E ? 4
                                                   : 0;
    if (length == 0 || at + length > text.size()) return false;
    std::uint32_t code = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[at + k]);
      if ((next & 0xC0) != 0x80) return false;
      code = code << 6 | (next & 0x3FU);
    }
    if (length > 1 && code < first_of_length[length]) return false;
    if (code > last || (code >= surrogates && code < after_surrogates)) return false;
    at += length;
  }
  return true;
}

bool has_control_character(std::string_view text) {
  return std::ranges::any_of(text, [](unsigned char c) { return c < ' ' || c == 0x7f; });
}

ReadNumber read_number(const std::string& text) {
  const std::string number = trimmed(text);
  const std::size_t sign = !number.empty() && (number[0] == '+' || number[0] == '-') ? 1 : 0;
  const std::string unsigned_text = lower(number.substr(sign));
  for (const char* word : {"nan", "inf", "infinity"})
    if (unsigned_text == word) return {.status = ReadNumber::Status::not_finite};

  // from_chars knows no plus sign and, unlike strtod, reads no hexadecimal numbers and ignores the locale.
  if (number.starts_with("+-")) return {};
  const char* first = number.data() + (number.starts_with("+") ? 1 : 0);
  const char* last = number.data() + number.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::result_out_of_range) return {.status = ReadNumber::Status::out_of_reach};
  if (error != std::errc{} || !std::isfinite(value)) return {};
  if (end != last)
    return {.status = ReadNumber::Status::trailing_text, .trailing = trimmed(std::string_view(end, last))};
  return {ReadNumber::Status::number, value, ""};
}

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t rows = a.size() + 1;
  const std::size_t columns = b.size() + 1;
  std::vector<std::vector<int>> d(rows, std::vector<int>(columns, 0));
  for (std::size_t i = 0; i < rows; ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j < columns; ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i)
    for (std::size_t j = 1; j < columns; ++j) {
      const int replace = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + replace});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[rows - 1][columns - 1];
}

namespace {

// Letters and digits in lower case, by which "VG 68" is found in mineral-vg68.
std::string core_of(const std::string& text) {
  std::string core;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) core += lower(c);
  return core;
}

// Shortest candidate that contains the name; empty if there is none, or if the name is too short to be specific.
std::string containing(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t telling = 3;  // "vg6", "pao"; two letters occur in too many words
  const std::string core = core_of(name);
  std::string best;
  if (core.size() < telling) return best;
  for (const std::string& candidate : candidates)
    if (core_of(candidate).find(core) != std::string::npos && (best.empty() || candidate.size() < best.size()))
      best = candidate;
  return best;
}

}  // namespace

std::string nearest(const std::string& name, const std::vector<std::string>& candidates) {
  if (name.size() > 64) return "";  // not a typing error, and the distance of a very long text is expensive
  std::string best;
  int best_distance = 0;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(name, candidate);
    if (best.empty() || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  const int letters = static_cast<int>(std::max(name.size(), best.size()));
  // A short name is not similar to another one if half of it differs.
  const bool near = best_distance <= std::max(2, letters / 3) && 2 * best_distance <= letters;
  return near ? best : containing(name, candidates);
}

}  // namespace ehl::deck
