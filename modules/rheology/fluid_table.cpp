#include "rheology/fluid_table.hpp"

#include "deck/text.hpp"
#include "deck/text_table.hpp"

namespace ehl::rheology {
namespace {

constexpr std::size_t fewest_rows = 4;  // one more than monotone_curve() needs

// Reason why the row cannot follow the previous ones; empty if it can.
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
  const deck::ReadColumns read = deck::read_columns(path, {{{"p", "pressure"}, "Pa"},
                                                           {{"eta", "viscosity", "dynamic viscosity"}, "Pa s"},
                                                           {{"rho", "density"}, "kg/m^3", with_rho}});
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  FluidTable table;
  for (const deck::ColumnRow& row : std::get<deck::ColumnTable>(read).rows) {
    const double p = row.values[0], eta = row.values[1], rho = row.values[2];
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
