// The section about the table of a sweep.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case/numbers/number.hpp"
#include "page/markup.hpp"
#include "page/section.hpp"
#include "page/table_words.hpp"
#include "tables/labels.hpp"
#include "tables/series.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_rows_of_table = 400;

numbers::OfSweep shown_as(const std::string& column) {
  const numbers::Number* number = numbers::number_of_column(column);
  return number == nullptr ? numbers::OfSweep::hidden : number->of_sweep;
}

bool solved(const SweepData& table, std::size_t row) { return table.cell(row, id::status) == "converged"; }

std::string status_words(const SweepData& table) {
  std::string text = fmt::format("{} cases", table.rows.size());
  for (const std::string& status : table.words(id::status)) {
    std::size_t count = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) count += table.cell(row, id::status) == status ? 1 : 0;
    text += fmt::format(", {} ", count) + status;
  }
  return text;
}

// "57.4 ± 1.5"; marked if it did not converge.
std::string cell_with_bar(const SweepData& table, std::size_t row, const std::string& column) {
  const double value = table.number(row, column);
  if (!solved(table, row)) return not_converged_cell("");
  if (!std::isfinite(value)) return escaped(table.cell(row, column) == "NaN" ? "–" : table.cell(row, column));
  const double error = error_bar(table, row, column);
  return digits(value, error) + (error > 0.0 ? " ± " + bar_digits(error) : "");
}

std::string cases_table(const SweepData& table) {
  std::vector<std::string> shown = films(table);
  const std::string in_si = numbers::column_in_si(id::p_max);
  for (const std::string& column : table.columns)
    if (shown_as(column) != numbers::OfSweep::hidden && !(column == id::P_max && table.has(in_si)))
      shown.push_back(column);
  HtmlTable made{"", {}, {}, "numbers"};
  for (const std::string& key : table.varied) made.head.push_back(with_indices(with_unit(table, key)));
  made.head.push_back(id::status);
  for (const std::string& name : shown)
    made.head.push_back(with_indices(name.ends_with("_deviation") ? words_for(name) + " [%]" : with_unit(table, name)));
  made.head.push_back(id::warnings);
  const std::size_t rows = std::min(table.rows.size(), most_rows_of_table);
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<std::string> cells;
    for (const std::string& key : table.varied)
      cells.push_back(std::isfinite(table.number(row, key)) ? fmt::format("{:.6g}", table.number(row, key))
                                                            : escaped(table.cell(row, key)));
    cells.push_back(solved(table, row) ? "converged" : not_converged_cell(escaped(table.cell(row, id::status))));
    for (const std::string& name : shown) {
      const double value = table.number(row, name);
      cells.push_back(!name.ends_with("_deviation") ? cell_with_bar(table, row, name)
                      : std::isfinite(value)        ? fmt::format("{:+.1f}", 100.0 * value)
                                                    : "–");
    }
    cells.push_back(table.has(id::warnings) ? escaped(table.cell(row, id::warnings)) : "");
    made.rows.push_back(cells);
  }
  made.caption =
      "Value ± error bar (mesh and cycles); where no bar stands, none is estimated. Formulas (hd: Hamrock, Dowson "
      "1977; moes: Moes 1992): over the film computed, less 1.";
  if (rows < table.rows.size()) made.caption += fmt::format(" The first {} of {} cases.", rows, table.rows.size());
  return made.text();
}

std::string reasons(const SweepData& table) {
  HtmlTable made{"Cases without a result", {"case", id::status, id::reason}, {}, "main"};
  for (std::size_t row = 0; row < table.rows.size() && made.rows.size() < 50; ++row) {
    if (solved(table, row)) continue;
    std::string name;
    for (const std::string& key : table.varied) name += (name.empty() ? "" : ", ") + key + " = " + table.cell(row, key);
    made.rows.push_back({escaped(name), escaped(table.cell(row, id::status)),
                         table.has(id::reason) ? escaped(table.cell(row, id::reason)) : ""});
  }
  return made.rows.empty() ? "" : made.text();
}

}  // namespace

PageSection sweep_section(const std::string& path, const DrawnFigures& figures) {
  const SweepData table = read_sweep(path);
  PageSection section{"", path, "", {"sweep", {escaped(status_words(table))}}};
  const bool all_solved = table.words(id::status) == std::vector<std::string>{"converged"};
  section.markup = "<p class=\"" + std::string(all_solved ? "fine" : "alarm") + "\">" + escaped(status_words(table)) +
                   "</p>\n" + origin_of(table) + figures_markup(figures) + cases_table(table) + reasons(table) +
                   comments_of(table);
  return section;
}

}  // namespace ehl::program
