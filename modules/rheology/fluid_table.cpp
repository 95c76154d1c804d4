#include "rheology/fluid_table.hpp"

#include <cmath>

#include "deck/file.hpp"
#include "deck/text.hpp"

namespace ehl::rheology {
namespace {

constexpr std::size_t most_columns = 3;
constexpr std::size_t fewest_rows = 4;  // one more than monotone_curve takes

// Empty where the row may follow those before it.
std::string what_is_wrong(const FluidTable& table, double p, double eta, double rho, bool with_rho) {
  const auto text = [](double value) { return deck::shortest(value); };
  if (table.p.empty() && p != 0.0)
    return "p = " + text(p) + " Pa: the first row must be that of ambient pressure, p = 0";
  if (!(eta > 0.0)) return "eta = " + text(eta) + " Pa s: must be > 0";
  if (with_rho && !(rho > 0.0)) return "rho = " + text(rho) + " kg/m^3: must be > 0";
  if (table.p.empty()) return {};
  if (!(p > table.p.back()))
    return "p = " + text(p) + " Pa after " + text(table.p.back()) + ": pressures must rise from row to row";
  if (!(eta > table.eta.back()))
    return "eta = " + text(eta) + " Pa s after " + text(table.eta.back()) + ": viscosity must rise with pressure";
  if (with_rho && !(rho > table.rho.back()))
    return "rho = " + text(rho) + " kg/m^3 after " + text(table.rho.back()) + ": density must rise with pressure";
  return {};
}

}  // namespace

ReadTable read_fluid_table(const std::string& path, bool with_rho) {
  FluidTable table;
  const std::size_t columns = with_rho ? 3 : 2;
  const std::string wanted = with_rho ? "p [Pa], eta [Pa s], rho [kg/m^3]" : "p [Pa], eta [Pa s]";
  for (const deck::Row& row : deck::rows_of(path)) {
    // A density that nobody asks for may stand.
    if (row.cells.size() < columns || row.cells.size() > most_columns)
      return row.place + ": " + std::to_string(row.cells.size()) + " columns, and " + std::to_string(columns) +
             " are needed: " + wanted;
    double numbers[3] = {};
    for (std::size_t k = 0; k < columns; ++k) {
      numbers[k] = deck::read_number(row.cells[k]).value;
      if (std::isnan(numbers[k]))
        return row.place + ": " + deck::quoted(row.cells[k]) + " is no number: the columns are " + wanted;
    }
    const auto [p, eta, rho] = numbers;
    if (const std::string wrong = what_is_wrong(table, p, eta, rho, with_rho); !wrong.empty())
      return row.place + ": " + wrong;
    table.p.push_back(p);
    table.eta.push_back(eta);
    if (with_rho) table.rho.push_back(rho);
  }
  if (table.p.size() < fewest_rows)
    return path + ": " + std::to_string(table.p.size()) + " rows are too few: at least " + std::to_string(fewest_rows);
  return table;
}

}  // namespace ehl::rheology
