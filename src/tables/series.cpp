#include "tables/series.hpp"

#include <cmath>
#include <map>

#include "case/numbers/number.hpp"

namespace ehl::program {

FormulasOfTable published_for(const SweepData& table) {
  const std::string film = numbers::column_in_si(id::hc);
  if (table.has(column_of(published::moes, film))) return {{published::dh, published::moes, {}}};
  return {{published::hd, published::nvm, published::chittenden}};
}

std::string column_of(const Publication& formula, const std::string& y) { return std::string(formula.code) + "_" + y; }

std::string longest_key(const SweepData& table) {
  std::string longest;
  std::size_t most = 2;
  for (const std::string& key : table.varied)
    if (const std::size_t count = table.words(key).size(); count > most && table.is_numeric(key)) {
      most = count;
      longest = key;
    }
  return longest;
}

std::vector<std::string> films_in_si() { return {numbers::column_in_si(id::hc), numbers::column_in_si(id::hm)}; }

std::vector<std::string> films(const SweepData& table) {
  // The table of runs in time shows the least films instead of those at time 0.
  const std::vector<std::string> least_in_si{numbers::column_in_si(id::least_hc), numbers::column_in_si(id::least_hm)};
  if (table.has(least_in_si[0])) return least_in_si;
  if (table.has(id::least_Hc)) return {id::least_Hc, id::least_Hm};
  if (const std::vector<std::string> in_si = films_in_si(); table.has(in_si[0])) return in_si;
  return table.has(id::Hc) ? std::vector<std::string>{id::Hc, id::Hm} : std::vector<std::string>{};
}

std::vector<std::vector<std::size_t>> curves_by(const SweepData& table, const std::vector<std::string>& by) {
  std::vector<std::vector<std::size_t>> curves;
  std::map<std::string, std::size_t> known;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::string words;
    for (const std::string& column : by) words += table.cell(row, column) + ",";
    const auto [curve, is_new] = known.try_emplace(words, curves.size());
    if (is_new) curves.emplace_back();
    curves[curve->second].push_back(row);
  }
  return curves;
}

double error_bar(const SweepData& table, std::size_t row, const std::string& y) {
  const numbers::BarColumns bars = numbers::bar_columns(y);
  if (table.has(bars.in_unit)) return table.number(row, bars.in_unit);
  return table.has(bars.relative) ? table.number(row, bars.relative) * std::abs(table.number(row, y)) : 0.0;
}

}  // namespace ehl::program
