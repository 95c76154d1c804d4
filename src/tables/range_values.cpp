#include "tables/range_values.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::program {

std::vector<std::string> parts_between(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at < text.size() && text[at] != separator) continue;
    parts.push_back(deck::trimmed(text.substr(begin, at - begin)));
    begin = at + 1;
  }
  return parts;
}

std::vector<std::string> values_of_range(const std::string& text, const std::string& said) {
  const std::vector<std::string> parts = parts_between(text, ':');
  const auto refuse_if = [&](bool wrong, const std::string& why) {
    if (wrong) throw core::InputError(said + why);
  };
  refuse_if(parts.size() < 3 || parts.size() > 4, "'" + text + "': a range is a:b:n or a:b:n:log");
  const auto number = [&](const std::string& part) {
    const deck::ReadNumber read = deck::read_number(part);
    refuse_if(read.status != deck::ReadNumber::Status::number,
              "'" + part + "' is not a number: a range is a:b:n or a:b:n:log");
    return read.value;
  };
  const double a = number(parts[0]), b = number(parts[1]), n = number(parts[2]);
  const bool logarithmic = parts.size() == 4;
  refuse_if(logarithmic && parts[3] != "log", "'" + parts.back() + "' in '" + text + "': only log may follow a:b:n");
  refuse_if(n != std::floor(n) || n < 2.0 || n > most_cases_of_sweep,
            "n = " + parts[2] + " in '" + text + "': must be a whole number >= 2 and <= 1000000");
  refuse_if(logarithmic && (a <= 0.0 || b <= 0.0), "'" + text + "': both ends of a logarithmic range must be > 0");
  refuse_if(a == b, "'" + text + "': the ends of a range must differ");

  std::vector<std::string> values{parts[0]};
  for (double k = 1.0; k + 1.0 < n; ++k) {
    const double t = k / (n - 1.0);
    // Twelve digits, so that rounding does not show: 20 instead of 19.999999999999996.
    values.push_back(fmt::format("{:.12g}", logarithmic ? a * std::pow(b / a, t) : a + (b - a) * t));
  }
  values.push_back(parts[1]);
  return values;
}

}  // namespace ehl::program
