// The section about the table of a sweep.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case/numbers/number.hpp"
#include "page/drawing.hpp"
#include "page/markup.hpp"
#include "page/section.hpp"
#include "page/table_words.hpp"
#include "tables/labels.hpp"
#include "tables/series.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_curves_of_figure = 12;
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

// One quantity against the key with most values, one curve for each combination of the other keys.
std::string curves_figure(const SweepData& table, const std::string& x, const std::vector<std::string>& by,
                          const std::string& y) {
  const std::vector<std::vector<std::size_t>> curves = curves_by(table, by);
  const Publication formula = published_for(table)[0];
  const std::string beside = table.has(column_of(formula, y)) ? column_of(formula, y) : "";
  std::vector<double> xs, ys;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (solved(table, row)) {
      xs.push_back(table.number(row, x));
      ys.push_back(table.number(row, y));
      if (!beside.empty()) ys.push_back(table.number(row, beside));
    }
  if (std::ranges::none_of(ys, [](double value) { return std::isfinite(value); })) return "";
  const Axis horizontal = axis_of(xs, with_unit(table, x), spans(xs, 4.0));
  Drawing drawing(horizontal, axis_of(ys, with_unit(table, y), spans(ys, 4.0)));
  std::vector<LegendEntry> legend;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    std::vector<std::size_t> rows = curves[k];
    std::erase_if(rows, [&](std::size_t row) { return !solved(table, row); });
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return table.number(row, x); });
    std::vector<double> at, value, bar, published;
    for (const std::size_t row : rows) {
      at.push_back(table.number(row, x));
      value.push_back(table.number(row, y));
      bar.push_back(error_bar(table, row, y));
      if (!beside.empty()) published.push_back(table.number(row, beside));
    }
    const Stroke stroke{curve_colour(k), 1.6, ""};
    if (!beside.empty()) drawing.curve(at, published, {stroke.colour, 1.0, "5 3"});
    drawing.curve(at, value, stroke);
    drawing.bars(at, value, bar, stroke.colour);
    drawing.points(at, value, stroke.colour);
    if (!by.empty()) legend.push_back({name_of_curve(table, by, curves[k][0]), stroke});
  }
  if (!beside.empty()) legend.push_back({std::string("dashed: ") + formula.name, {"#888888", 1.0, "5 3"}});
  const std::string words = with_unit(table, y) + " against " + words_for(x);
  return figure(drawing.svg(words), legend, with_indices(words) + ", with error bars.");
}

std::string all_curves(const SweepData& table) {
  const std::string x = longest_key(table);
  if (x.empty()) return "";
  std::vector<std::string> by;
  for (const std::string& key : table.varied)
    if (key != x && table.words(key).size() > 1) by.push_back(key);
  if (curves_by(table, by).size() > most_curves_of_figure)
    return "<p class=\"small\">More curves than a figure holds: `ehl plot --x KEY --by KEY` draws a choice of "
           "them.</p>\n";
  std::vector<std::string> quantities = films(table);
  for (const std::string& column : table.columns)
    if (shown_as(column) == numbers::OfSweep::as_curve) quantities.push_back(column);
  std::string text;
  for (const std::string& y : quantities)
    if (table.is_numeric(y)) text += curves_figure(table, x, by, y);
  return text;
}

// The cases in the plane of M and L.
std::string map_of_loads(const SweepData& table) {
  const bool both = table.has(id::M) && table.has(id::L) &&
                    std::ranges::all_of(
                        table.varied, [](const std::string& key) { return key == "contact.M" || key == "contact.L"; });
  if (!both || table.varied.size() != 2) return "";
  std::vector<double> M, L;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    M.push_back(table.number(row, "contact.M"));
    L.push_back(table.number(row, "contact.L"));
  }
  Drawing drawing(axis_of(M, "M", spans(M, 4.0)), axis_of(L, "L"), 400.0, 260.0);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (!solved(table, row)) {
      drawing.cross(M[row], L[row]);
      continue;
    }
    drawing.points({M[row]}, {L[row]}, curve_colour(0), 2.5);
    if (table.rows.size() <= 120) drawing.words(M[row], L[row], " " + fmt::format("{:.3g}", table.number(row, id::Hc)));
  }
  return figure(
      drawing.svg("The cases in the plane of M and L"),
      {{"converged, with H_c", {curve_colour(0), 1.0, ""}, true}, {"not converged: red cross", {"#b2182b", 2.0, ""}}},
      "Map of loads.");
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

PageSection sweep_section(const std::string& path) {
  const SweepData table = read_sweep(path);
  PageSection section{"", path, "", {"sweep", {escaped(status_words(table))}}};
  const bool all_solved = table.words(id::status) == std::vector<std::string>{"converged"};
  section.markup = "<p class=\"" + std::string(all_solved ? "fine" : "alarm") + "\">" + escaped(status_words(table)) +
                   "</p>\n" + origin_of(table) + "<div class=\"figures\">\n" + all_curves(table) + map_of_loads(table) +
                   "</div>\n" + cases_table(table) + reasons(table) + comments_of(table);
  return section;
}

}  // namespace ehl::program
