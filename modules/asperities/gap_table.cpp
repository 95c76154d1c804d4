#include "asperities/gap_table.hpp"

#include <algorithm>
#include <cmath>

#include "asperities/rough_map.hpp"
#include "deck/text.hpp"
#include "deck/text_table.hpp"

namespace ehl::asperities {
namespace {

enum { gap, pressure, phi_x, phi_y };  // the first columns of map_columns(), which matter here

// Only gap and pressure are required; what else `ehl asperities` writes may be there.
std::vector<deck::Column> columns_of_table() {
  std::vector<deck::Column> columns;
  for (const MapColumn& column : map_columns())
    columns.push_back({.names = {column.name}, .unit = column.unit, .required = columns.size() <= pressure});
  return columns;
}

constexpr std::size_t fewest_points = 3;  // of a smooth curve

// What is wrong with a row after the one before it; empty if nothing is.
std::string wrong_row(const deck::ColumnRow& row, const deck::ColumnRow* before, bool factors) {
  const double h = row.values[gap], p = row.values[pressure];
  const auto complain = [&](const std::string& what) { return row.place + ": " + what; };
  if (!std::isfinite(h)) return complain("the gap must be a finite number");
  if (!(p >= 0.0) || !std::isfinite(p)) return complain("the pressure must be a finite number >= 0");
  for (const int phi : {phi_x, phi_y})
    if (factors && (!(row.values[static_cast<std::size_t>(phi)] >= 0.0) ||
                    !std::isfinite(row.values[static_cast<std::size_t>(phi)])))
      return complain("a flow factor must be a finite number >= 0");
  if (before == nullptr) return {};
  if (!(h > before->values[gap])) return complain("the gap " + deck::shortest(h) + " m stands twice");
  if (p > 0.0 && !(p < before->values[pressure]))
    return complain("the pressure must fall with the gap, and " + deck::shortest(p) + " Pa at " + deck::shortest(h) +
                    " m is not below " + deck::shortest(before->values[pressure]) + " Pa at " +
                    deck::shortest(before->values[gap]) + " m");
  return {};
}

}  // namespace

std::size_t GapTable::touching() const {
  return static_cast<std::size_t>(std::ranges::count_if(pressure, [](double p) { return p > 0.0; }));
}

std::variant<GapTable, std::string> read_gap_table(const std::string& path) {
  const deck::ReadColumns read = deck::read_columns(path, columns_of_table());
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  deck::ColumnTable table = std::get<deck::ColumnTable>(read);
  std::ranges::stable_sort(table.rows, {}, [](const deck::ColumnRow& row) { return row.values[gap]; });
  if (table.present[phi_x] != table.present[phi_y])
    return path + ": the columns phi_x and phi_y must both be there, or neither";
  const bool factors = table.present[phi_x];
  GapTable all;
  const deck::ColumnRow* before = nullptr;
  for (const deck::ColumnRow& row : table.rows) {
    if (std::string wrong = wrong_row(row, before, factors); !wrong.empty()) return wrong;
    before = &row;
    all.gap.push_back(row.values[gap]);
    all.pressure.push_back(row.values[pressure]);
    if (!factors) continue;
    all.phi_x.push_back(row.values[phi_x]);
    all.phi_y.push_back(row.values[phi_y]);
  }
  if (all.touching() < fewest_points)
    return path + ": " + std::to_string(all.touching()) + " rows with a pressure > 0 are too few: at least " +
           std::to_string(fewest_points);
  return all;
}

}  // namespace ehl::asperities
