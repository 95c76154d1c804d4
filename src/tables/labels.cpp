#include "tables/labels.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "case/numbers/number.hpp"
#include "deck/text.hpp"
#include "tables/series.hpp"

namespace ehl::program {
namespace {

// Escapes characters that gnuplot would interpret.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += (std::string("_^{}@&~\\").find(c) == std::string::npos ? "" : "\\") + std::string(1, c);
  return result;
}

std::string unit_of(const SweepData& table, const std::string& column) {
  const auto unit = table.units.find(column);
  return unit == table.units.end() ? "" : unit->second == "C" ? "°C" : unit->second;
}

// A number with an SI prefix: "2 MPa" for 2e6 Pa.
std::string with_prefix(double number, const std::string& unit) {
  struct Prefix {
    const char* of;
    double least;
    double factor;
    const char* unit;
  };
  constexpr Prefix prefixes[] = {{"Pa", 1e9, 1e-9, "GPa"},   {"Pa", 1e6, 1e-6, "MPa"},    {"m", 1.0, 1.0, "m"},
                                 {"m", 1e-3, 1e3, "mm"},     {"m", 1e-6, 1e6, "µm"},      {"m", 0.0, 1e9, "nm"},
                                 {"Pa s", 1.0, 1.0, "Pa s"}, {"Pa s", 0.0, 1e3, "mPa s"}, {"1/Pa", 0.0, 1e9, "1/GPa"}};
  for (const Prefix& prefix : prefixes)
    if (unit == prefix.of && std::abs(number) >= prefix.least)
      return fmt::format("{:.4g} {}", number * prefix.factor, prefix.unit);
  return fmt::format("{:.4g}{}{}", number, unit.empty() ? "" : " ", unit);
}

// A key that is varied: its label, and its symbol for the names of curves.
struct KeyWords {
  const char* key;
  const char* words;
  const char* symbol;
};
constexpr KeyWords keys_in_words[] = {{"motion.u_m", "entrainment speed u_m", "u_m"},
                                      {"motion.srr", "slide-roll ratio", "srr"},
                                      {"contact.load", "load F", "F"},
                                      {"contact.radius_x", "R_x", "R_x"},
                                      {"contact.E_prime", "E'", "E'"},
                                      {"lubricant.eta0", "viscosity η_0", "η_0"},
                                      {"lubricant.temperature", "temperature", "T"},
                                      {"shear.tau_0", "τ_0", "τ_0"}};

std::string symbol_of(const std::string& column) {
  const auto known = std::ranges::find(keys_in_words, column, &KeyWords::key);
  return known != std::end(keys_in_words) ? known->symbol : escaped(column.substr(column.find('.') + 1));
}

}  // namespace

std::string words_for(const std::string& column) {
  if (const auto known = std::ranges::find(keys_in_words, column, &KeyWords::key); known != std::end(keys_in_words))
    return known->words;
  const numbers::Number* number = numbers::number_of_column(column);
  return number != nullptr && !number->label.empty() ? number->label : symbol_of(column);
}

std::string with_unit(const SweepData& table, const std::string& column) {
  const std::string unit = unit_of(table, column);
  return words_for(column) + (unit.empty() ? "" : " [" + unit + "]");
}

std::string words_of_all(const SweepData& table, const std::vector<std::string>& columns) {
  if (columns == films_in_si()) return "film thickness h [nm]";
  if (columns == std::vector<std::string>{id::Hc, id::Hm}) return "film thickness H = hR/a^2";
  std::vector<std::string> words;
  for (const std::string& column : columns) words.push_back(with_unit(table, column));
  return deck::joined(words, ", ");
}

std::string name_of_curve(const SweepData& table, const std::vector<std::string>& by, std::size_t row) {
  std::vector<std::string> parts;
  for (const std::string& column : by) {
    const double number = table.number(row, column);
    parts.push_back(std::isfinite(number) ? symbol_of(column) + " = " + with_prefix(number, unit_of(table, column))
                                          : escaped(table.cell(row, column)));
  }
  return deck::joined(parts, ", ");
}

}  // namespace ehl::program
