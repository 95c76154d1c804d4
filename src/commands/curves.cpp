#include "commands/curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/numbers/number.hpp"
#include "deck/text.hpp"
#include "tables/labels.hpp"
#include "tables/series.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t most_curves = 12;  // the number of colours that the eye can distinguish

void check_column(const SweepData& table, const std::string& option, const std::string& column, bool numbers) {
  const std::string said = "--" + option + " " + column;
  if (!table.has(column))
    refuse(said + ": the table has no such column" + suggestion(column, table.columns) + " It has " +
           deck::joined(table.columns, ", "));
  if (numbers && !table.is_numeric(column)) refuse(said + ": this column contains words, and an axis needs numbers");
}

CurvesWanted defaults(const SweepData& table, std::string x) {
  CurvesWanted chosen{std::move(x), films(table), {}, ""};
  for (const std::string& key : table.varied)
    if (key != chosen.x && table.words(key).size() > 1) chosen.by.push_back(key);
  // Two films for many curves would overload the picture; only the first is drawn.
  if (curves_by(table, chosen.by).size() > 3 && chosen.y.size() > 1) chosen.y.pop_back();
  return chosen;
}

std::string block(const SweepData& table, std::vector<std::size_t> rows, const std::string& x, const std::string& y) {
  std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return table.number(row, x); });
  std::string text;
  for (const std::size_t row : rows) {
    if (table.cell(row, id::status) != "converged") continue;
    text += fmt::format("{:.9g} {:.9g} {:.9g}", table.number(row, x), table.number(row, y), error_bar(table, row, y));
    for (const Publication& formula : published_for(table)) {
      const std::string column = column_of(formula, y);
      text += " " + (table.has(column) ? fmt::format("{:.9g}", table.number(row, column)) : std::string("nan"));
    }
    text += "\n";
  }
  return text.empty() ? "nan nan nan nan nan nan\n" : text;
}

bool any(const SweepData& table, const std::vector<std::string>& y, const Publication& formula) {
  return std::ranges::any_of(y, [&](const std::string& name) { return table.has(column_of(formula, name)); });
}

// The roughness if it is the same in all rows, apart from rounding; else 0.
double one_roughness(const SweepData& table) {
  const std::string column = numbers::column_in_si(id::Sq_si);
  if (!table.has(column)) return 0.0;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (const double Sq = table.number(row, column); std::isfinite(Sq)) {
      least = std::min(least, Sq);
      most = std::max(most, Sq);
    }
  return most > 0.0 && most - least < 1e-9 * most ? most : 0.0;
}

}  // namespace

bool makes_curves(const SweepData& table) {
  const std::string x = longest_key(table);
  // The film hardly depends on sliding and is shown below the friction instead.
  const bool traction = x == "motion.srr" && table.has(id::mu);
  return !x.empty() && !traction && !films(table).empty() && !too_many_curves(table);
}

bool too_many_curves(const SweepData& table) {
  return curves_by(table, defaults(table, longest_key(table)).by).size() > most_curves;
}

bool has_points(const SweepData& table, const std::vector<std::string>& columns) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (const std::string& column : columns)
      if (table.cell(row, id::status) == "converged" && std::isfinite(table.number(row, column))) return true;
  return false;
}

CurvesWanted chosen_curves(const SweepData& table, const Arguments& arguments) {
  const std::string x = arguments.value("x", longest_key(table));
  if (x.empty()) refuse(table.path + ": no swept key has three values: choose the axes with --x and --y");
  check_column(table, "x", x, true);
  CurvesWanted wanted = defaults(table, x);
  wanted.axes = arguments.value("axes", "");
  if (!wanted.axes.empty() && wanted.axes != "log" && wanted.axes != "linear")
    refuse("--axes " + wanted.axes + ": must be log or linear");
  if (arguments.has("y")) wanted.y = arguments.values("y");
  if (arguments.has("by")) wanted.by = arguments.values("by");
  for (const std::string& y : wanted.y) check_column(table, "y", y, true);
  for (const std::string& by : wanted.by) check_column(table, "by", by, false);
  const std::size_t curves = curves_by(table, wanted.by).size();
  if (curves * wanted.y.size() > most_curves * (wanted.y.size() > 1 ? 2 : 1))
    refuse(fmt::format("{}: {} curves, but a picture can show {}: vary fewer values, or choose the curves with --by",
                       table.path, curves, most_curves));
  return wanted;
}

Curves curves_of(const SweepData& table, const CurvesWanted& wanted) {
  Curves made;
  const std::vector<std::vector<std::size_t>> curves = curves_by(table, wanted.by);
  for (std::size_t q = 0; q < wanted.y.size(); ++q)
    for (const std::vector<std::size_t>& rows : curves) made.data += block(table, rows, wanted.x, wanted.y[q]) + "\n\n";
  const auto number = [&](const std::string& name, double value) {
    made.settings.push_back({name, fmt::format("{:.9g}", value), false});
  };
  const auto text = [&](const std::string& name, const std::string& value) {
    made.settings.push_back({name, value, true});
  };
  number("curves", static_cast<double>(curves.size()));
  number("quantities", static_cast<double>(wanted.y.size()));
  for (std::size_t k = 0; k < curves.size(); ++k)
    text(fmt::format("curve_{}", k + 1), name_of_curve(table, wanted.by, curves[k][0]));
  for (std::size_t q = 0; q < wanted.y.size(); ++q) text(fmt::format("quantity_{}", q + 1), words_for(wanted.y[q]));
  for (std::size_t q = 0; q < wanted.y.size(); ++q) text(fmt::format("axis_{}", q + 1), with_unit(table, wanted.y[q]));
  const FormulasOfTable published = published_for(table);
  for (std::size_t f = 0; f < published.size(); ++f)
    text(fmt::format("formula_{}", f + 1), any(table, wanted.y, published[f]) ? published[f].name : "");
  text("x_words", with_unit(table, wanted.x));
  text("y_words", words_of_all(table, wanted.y));
  const bool both = wanted.y.size() > 1;
  text("lambda_words", both                              ? "λ = h/S_q"
                       : wanted.y[0] == films_in_si()[1] ? "λ = " + numbers::symbol_of(id::hm) + "/S_q"
                                                         : "λ_c = " + numbers::symbol_of(id::hc) + "/S_q");
  const std::vector<std::string> in_si = films_in_si();
  number("roughness",
         std::ranges::all_of(wanted.y, [&](const auto& y) { return std::ranges::find(in_si, y) != in_si.end(); })
             ? one_roughness(table)
             : 0.0);
  if (made.data.find_first_of("0123456789") == std::string::npos)
    refuse(table.path + ": no case has a converged solution: there is nothing to draw");
  const auto lost = std::ranges::count_if(table.rows, [&](const auto& row) {
    return row[static_cast<std::size_t>(std::ranges::find(table.columns, id::status) - table.columns.begin())] !=
           "converged";
  });
  text("axes", wanted.axes);
  number("lost", static_cast<double>(lost));
  number("rows_of_table", static_cast<double>(table.rows.size()));
  return made;
}

}  // namespace ehl::program
