#include "rheology/fluid_table.hpp"

#include "deck/file.hpp"
#include "deck/text.hpp"

namespace ehl::rheology {
namespace {

constexpr std::size_t fewest_rows = 4;

std::vector<std::string> cells_of(const std::string& line) {
  std::string blanks = line;
  for (char& c : blanks)
    if (c == ';' || c == '\t') c = ',';
  return deck::split_words(blanks);
}

bool is_number(const std::string& cell) { return deck::read_number(cell).status == deck::ReadNumber::Status::number; }

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
  std::ifstream file = deck::opened(path);
  FluidTable table;
  const std::size_t columns = with_rho ? 3 : 2;
  const std::string wanted = with_rho ? "p [Pa], eta [Pa s], rho [kg/m^3]" : "p [Pa], eta [Pa s]";
  int number = 0;
  bool heading_allowed = true;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::string where = path + ":" + std::to_string(number) + ": ";
    const std::vector<std::string> cells = cells_of(deck::trimmed(line.substr(0, line.find('#'))));
    if (cells.empty()) continue;
    if (heading_allowed && !is_number(cells[0])) {
      heading_allowed = false;
      continue;
    }
    heading_allowed = false;
    if (cells.size() < columns)
      return where + std::to_string(cells.size()) + " columns, and " + std::to_string(columns) +
             " are needed: " + wanted;
    for (std::size_t k = 0; k < columns; ++k)
      if (!is_number(cells[k])) return where + deck::quoted(cells[k]) + " is no number: the columns are " + wanted;
    const double p = deck::read_number(cells[0]).value, eta = deck::read_number(cells[1]).value;
    const double rho = with_rho ? deck::read_number(cells[2]).value : 0.0;
    if (const std::string wrong = what_is_wrong(table, p, eta, rho, with_rho); !wrong.empty()) return where + wrong;
    table.p.push_back(p);
    table.eta.push_back(eta);
    if (with_rho) table.rho.push_back(rho);
  }
  if (table.p.size() < fewest_rows)
    return path + ": " + std::to_string(table.p.size()) + " rows are too few: at least " + std::to_string(fewest_rows);
  return table;
}

}  // namespace ehl::rheology
