#include "tables/series.hpp"

#include <cmath>
#include <map>

namespace ehl::program {

FormulasOfTable published_for(const SweepData& table) {
  if (table.has("moes_h_c_nm"))
    return {{{"dh", "Dowson, Higginson 1968; Toyoda 1979"}, {"moes", "Moes 1992"}, {"", ""}}};
  return {{{"hd", "Hamrock, Dowson 1977"},
           {"nvm", "Nijenbanning, Venner, Moes 1994"},
           {"chittenden", "Chittenden et al. 1985"}}};
}

std::string column_of(const PublishedFormula& formula, const std::string& y) {
  return std::string(formula.code) + "_" + y;
}

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

std::vector<std::string> films(const SweepData& table) {
  if (table.has("h_c_nm")) return {"h_c_nm", "h_m_nm"};
  return table.has("Hc") ? std::vector<std::string>{"Hc", "Hm"} : std::vector<std::string>{};
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
  const std::string absolute = y.ends_with("_nm") ? y.substr(0, y.size() - 3) + "_error_nm" : "";
  if (table.has(absolute)) return table.number(row, absolute);
  const std::string relative = "error_" + y;
  return table.has(relative) ? table.number(row, relative) * std::abs(table.number(row, y)) : 0.0;
}

}  // namespace ehl::program
