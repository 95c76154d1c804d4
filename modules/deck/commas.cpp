#include "deck/commas.hpp"

#include <algorithm>
#include <cctype>

#include "deck/text.hpp"

namespace ehl::deck {

Commas commas_of(const std::string& number) {
  const std::string text = trimmed(number);
  const std::size_t first = text.find(',');
  if (first == std::string::npos) return Commas::none;
  const auto digits = [&](std::size_t begin, std::size_t end) {
    return begin < end && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                      text.begin() + static_cast<std::ptrdiff_t>(end),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
  };
  // Groups of three digits behind one to three of them, which do not begin with 0.
  const std::size_t begin = text[0] == '+' || text[0] == '-' ? 1 : 0;
  const std::size_t end = std::min(text.find('.'), text.size());
  bool groups = first < end && first - begin <= 3 && digits(begin, first) && text[begin] != '0';
  for (std::size_t comma = first; comma < end && groups; comma += 4)
    groups = text[comma] == ',' && comma + 4 <= end && digits(comma + 1, comma + 4);
  if (groups && end < text.size()) groups = digits(end + 1, text.size());
  const bool once = std::count(text.begin(), text.end(), ',') == 1;
  std::string pointed = text;
  pointed[first] = '.';
  const bool decimal = once && end == text.size() && read_number(pointed).status == ReadNumber::Status::number;
  if (groups) return decimal ? Commas::either : Commas::thousands;
  return decimal ? Commas::decimal : Commas::other;
}

std::string two_meanings(const std::string& number) {
  const std::size_t comma = number.find(',');
  const std::string before = number.substr(0, comma), after = number.substr(comma + 1);
  return quoted(number) + " may be " + before + "." + after + " or " + before + after +
         ", and no other number of the file decides it: write it with a decimal point, or without the comma";
}

}  // namespace ehl::deck
