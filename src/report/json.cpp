#include "report/json.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "deck/text.hpp"

namespace ehl::program::json {
namespace {

// Length of the valid UTF-8 sequence that starts at k; 0 when there is none.
std::size_t sequence_length(const std::string& text, std::size_t k) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned char first = byte(k);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || k + length > text.size()) return 0;
  for (std::size_t m = 1; m < length; ++m)
    if ((byte(k + m) & 0xC0) != 0x80) return 0;
  const bool overlong = (first == 0xE0 && byte(k + 1) < 0xA0) || (first == 0xF0 && byte(k + 1) < 0x90);
  const bool surrogate = first == 0xED && byte(k + 1) >= 0xA0;
  const bool beyond = first == 0xF4 && byte(k + 1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string text(const std::string& value) {
  std::string result = "\"";
  for (std::size_t k = 0; k < value.size();) {
    const std::size_t length = sequence_length(value, k);
    const char c = value[k];
    if (length == 0) {
      result += "\\ufffd";
    } else if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
      result += escape.data();
    } else {
      result += value.substr(k, length);
    }
    k += length == 0 ? 1 : length;
  }
  return result + "\"";
}

std::string number(double value) { return std::isfinite(value) ? deck::shortest(value) : "null"; }

std::string boolean(bool value) { return value ? "true" : "false"; }

std::string object(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string result = "{";
  for (std::size_t k = 0; k < members.size(); ++k)
    result += (k == 0 ? "" : ", ") + text(members[k].first) + ": " + members[k].second;
  return result + "}";
}

std::string array(const std::vector<std::string>& values) {
  return std::string("[").append(deck::joined(values, ", ")).append("]");
}

}  // namespace ehl::program::json
