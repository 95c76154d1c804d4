#include "deck/units.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/constants.hpp"

namespace ehl::deck {
namespace {

constexpr double inch = 0.0254, pound_force = 4.4482216152605;

constexpr Unit known[] = {
    {"Pa", "Pa"},
    {"kPa", "Pa", 1e3},
    {"MPa", "Pa", 1e6},
    {"GPa", "Pa", 1e9},
    {"bar", "Pa", 1e5},
    {"N/mm^2", "Pa", 1e6},
    {"psi", "Pa", pound_force / (inch * inch)},
    {"Pa s", "Pa s"},
    {"mPa s", "Pa s", 1e-3},
    {"cP", "Pa s", 1e-3},
    {"P", "Pa s", 0.1},
    {"kg/m^3", "kg/m^3"},
    {"g/cm^3", "kg/m^3", 1e3},
    {"g/ml", "kg/m^3", 1e3},
    {"kg/l", "kg/m^3", 1e3},
    {"kg/dm^3", "kg/m^3", 1e3},
    {"m", "m"},
    {"cm", "m", 1e-2},
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"micron", "m", 1e-6},
    {"nm", "m", 1e-9},
    {"in", "m", inch},
    {"m/s", "m/s"},
    {"cm/s", "m/s", 1e-2},
    {"mm/s", "m/s", 1e-3},
    {"s", "s"},
    {"ms", "s", 1e-3},
    {"us", "s", 1e-6},
    {"min", "s", 60.0},
    {"N", "N"},
    {"mN", "N", 1e-3},
    {"kN", "N", 1e3},
    {"N/m", "N/m"},
    {"N/mm", "N/m", 1e3},
    {"kN/m", "N/m", 1e3},
    {"N m", "N m"},
    {"kN m", "N m", 1e3},
    {"W", "W"},
    {"kW", "W", 1e3},
    {"MW", "W", 1e6},
    {"1/Pa", "1/Pa"},
    {"1/MPa", "1/Pa", 1e-6},
    {"1/GPa", "1/Pa", 1e-9},
    {"C", "C"},
    {"degC", "C"},
    {"K", "C", 1.0, -273.15},
    {"degF", "C", 5.0 / 9.0, -160.0 / 9.0},
    {"1/K", "1/K"},
    {"1/C", "1/K"},
    {"mm^2/s", "mm^2/s"},
    {"cSt", "mm^2/s"},
    {"m^2/s", "m^2/s"},
    {"m^3/s", "m^3/s"},
    {"W/(m K)", "W/(m K)"},
    {"J/(kg K)", "J/(kg K)"},
    {"kJ/(kg K)", "J/(kg K)", 1e3},
    {"1/min", "1/min"},
    {"rpm", "1/min"},
    {"degrees", "degrees"},
    {"deg", "degrees"},
    {"rad", "degrees", 180.0 / core::pi},
    {"-", "-"},
    {"1", "-"},
    {"%", "-", 1e-2},
    {"per cent", "-", 1e-2},
    {"percent", "-", 1e-2},
};

// Different characters with the same meaning in units.
std::string in_ascii(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> same{{{"\u00b5", "u"},
                                                                                {"\u03bc", "u"},
                                                                                {"\u00b7", " "},
                                                                                {"\u22c5", " "},
                                                                                {"\u00d7", " "},
                                                                                {"\u00b2", "2"},
                                                                                {"\u00b3", "3"},
                                                                                {"\u207b\u00b9", "-1"},
                                                                                {"\u00b0", "deg"},
                                                                                {"\u2212", "-"},
                                                                                {"\u00a0", " "},
                                                                                {"\u202f", " "}}};
  std::string plain(text);
  for (const auto& [from, to] : same)
    for (std::size_t at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size()))
      plain.replace(at, from.size(), to);
  return plain;
}

// "kg m^-3" and "kg*m-3" as "kg/m^3": one divisor at the end with a negative power.
std::string as_quotient(const std::string& text) {
  const std::size_t minus = text.rfind('-');
  if (minus == std::string::npos || minus + 2 != text.size()) return text;
  std::size_t divisor = minus;
  if (divisor > 0 && text[divisor - 1] == '^') --divisor;
  const std::size_t begin = text.find_last_of(" *.", divisor);
  const char power = text[minus + 1];
  const std::string base = text.substr(begin == std::string::npos ? 0 : begin + 1, divisor - (begin + 1));
  const std::string above = begin == std::string::npos || begin == 0 ? "1" : text.substr(0, begin);
  return above + "/" + base + (power == '1' ? "" : std::string("^") + power);
}

// Text without blanks, product signs and power signs, which may be written in several ways.
std::string core_of(std::string_view text) {
  std::string core;
  for (const char c : as_quotient(in_ascii(text)))
    if (c != ' ' && c != '*' && c != '.' && c != '^' && c != '\t') core += c;
  return core;
}

}  // namespace

const Unit* find_unit(std::string_view text) {
  const std::string core = core_of(text);
  const auto found = std::ranges::find_if(known, [&](const Unit& unit) { return core_of(unit.name) == core; });
  return core.empty() || found == std::end(known) ? nullptr : &*found;
}

std::vector<std::string> units_of(std::string_view si) {
  std::vector<std::string> names;
  for (const Unit& unit : known)
    if (unit.si == si) names.emplace_back(unit.name);
  return names;
}

}  // namespace ehl::deck
