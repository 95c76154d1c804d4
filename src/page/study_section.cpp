// The sections about studies: error against cost, and the observed order of accuracy.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/text.hpp"
#include "page/markup.hpp"
#include "page/section.hpp"
#include "page/table_words.hpp"
#include "tables/labels.hpp"
#include "tables/series.hpp"
#include "tables/study_report.hpp"
#include "tables/time_study_report.hpp"

namespace ehl::program {
namespace {

// The rows of each method (the columns `by`), each sorted from coarse to fine.
std::vector<std::vector<std::size_t>> methods_of(const SweepData& table, const std::vector<std::string>& by,
                                                 const std::string& along) {
  std::vector<std::vector<std::size_t>> variants = curves_by(table, by);
  for (std::vector<std::size_t>& variant : variants)
    std::ranges::stable_sort(variant, {}, [&](std::size_t row) { return table.number(row, along); });
  return variants;
}

std::string name_of_rows(const SweepData& table, const std::vector<std::string>& by, std::size_t row) {
  std::vector<std::string> words;
  for (const std::string& column : by) words.push_back(table.cell(row, column));
  return deck::joined(words, ", ");
}

bool done(const SweepData& table, std::size_t row) {
  return table.cell(row, id::status) == "converged" || table.cell(row, id::status) == "complete";
}

double reference_error(const SweepData& table, const std::string& name) {
  const deck::ReadNumber read = deck::read_number(comment(table, "reference error " + name));
  return read.status == deck::ReadNumber::Status::number ? read.value : std::nan("");
}

// An error: "0.12 %"; "< 0.006 %" if it is below the error of the reference.
std::string error_words(const SweepData& table, std::size_t row, const std::string& name) {
  const double error = table.number(row, "deviation_" + name), known_to = reference_error(table, name);
  if (!std::isfinite(error)) return "–";
  return error < known_to ? fmt::format("&lt; {:.2g} %", 100.0 * known_to) : fmt::format("{:.2g} %", 100.0 * error);
}

// The observed order between two rows; a dash if one of the errors is below the error of the reference.
std::string order_words(const SweepData& table, std::size_t coarse, std::size_t fine, const std::string& name,
                        const std::string& along) {
  const double known_to = reference_error(table, name);
  const double e1 = table.number(coarse, "deviation_" + name), e2 = table.number(fine, "deviation_" + name);
  const double ratio = table.number(fine, along) / table.number(coarse, along);
  if (!(e1 > 0.0 && e2 > 0.0) || e1 <= known_to || e2 <= known_to || !(ratio > 0.0) || ratio == 1.0) return "–";
  return fmt::format("{:.1f}", std::log(e1 / e2) / std::log(ratio));
}

std::string convergence_table(const SweepData& table, const std::vector<std::string>& by, const std::string& along) {
  const std::vector<std::string> film_columns = films(table);
  const bool si = film_columns == films_in_si();
  const std::string c = film_columns.at(0), m = film_columns.at(1);
  HtmlTable made{"Errors against the reference, and the observed order from row to row",
                 {"method", "cells", id::status, si ? "h<sub>c</sub> [nm]" : id::Hc, "error", "order",
                  si ? "h<sub>m</sub> [nm]" : id::Hm, "error", "order", "work units", id::seconds},
                 {},
                 "numbers"};
  for (const std::vector<std::size_t>& variant : methods_of(table, by, along))
    for (std::size_t k = 0; k < variant.size(); ++k) {
      const std::size_t row = variant[k];
      const bool good = done(table, row);
      const std::string mark = good ? "" : "*";
      const auto film = [&](const std::string& column, const std::string& name) {
        const double value = table.number(row, column);
        return digits(value, value * std::max(table.number(row, "deviation_" + name), reference_error(table, name))) +
               mark;
      };
      const auto order = [&](const char* name) {
        if (k == 0) return std::string("–");
        const std::string found = order_words(table, variant[k - 1], row, name, along);
        return found + (found == "–" || (good && done(table, variant[k - 1])) ? "" : "*");
      };
      made.rows.push_back({k == 0 ? escaped(name_of_rows(table, by, row)) : "", escaped(table.cell(row, along)),
                           good ? "converged" : not_converged_cell(escaped(table.cell(row, id::status))),
                           film(c, id::Hc), error_words(table, row, id::Hc) + mark, order(id::Hc), film(m, id::Hm),
                           error_words(table, row, id::Hm) + mark, order(id::Hm),
                           digits(table.number(row, id::work_units), NAN),
                           digits(table.number(row, id::seconds), NAN)});
    }
  return made.text() +
         "<p class=\"small\">&lt;: below the error of the reference. *: not converged after these cycles. –: the order "
         "is not known.</p>\n";
}

std::string heading_of(const SweepData& table) { return comment(table, "title"); }

std::string count_words(const SweepData& table) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) count += done(table, row) ? 1 : 0;
  return fmt::format("{} solutions, {} of them converged", table.rows.size(), count);
}

std::string reference_words(const SweepData& table) {
  HtmlTable made{"The reference", {"", "value", "relative error"}, {}, "main"};
  for (const char* name : {id::Hc, id::Hm}) {
    const deck::ReadNumber read = deck::read_number(comment(table, std::string("reference ") + name));
    const double error = reference_error(table, name);
    if (read.status != deck::ReadNumber::Status::number) continue;
    made.rows.push_back({name, digits(read.value, read.value * error), fmt::format("{:.2g} %", 100.0 * error)});
  }
  const std::string cells = comment(table, "reference cells");
  return made.rows.empty() ? ""
                           : made.text() + "<p class=\"small\">" + escaped(comment(table, "reference")) +
                                 (cells.empty() ? "" : "; cells " + escaped(cells)) + ".</p>\n";
}

}  // namespace

PageSection study_section(const std::string& path, const DrawnFigures& figures) {
  const SweepData table = read_table(path, study_mark);
  for (const char* column :
       {"cells", "wedge", "evaluator", id::cycles, "deviation_Hc", "deviation_Hm", id::seconds, id::work_units})
    if (!table.has(column)) throw core::FileError(path + ": the table is damaged: it has no column " + column);
  const std::vector<std::string> by{"wedge", "evaluator", id::cycles};
  return {heading_of(table),
          path,
          "<p class=\"facts\">" + count_words(table) + "</p>\n" + origin_of(table) + reference_words(table) +
              figures_markup(figures) + convergence_table(table, by, "cells") + comments_of(table),
          {"study", {count_words(table)}}};
}

PageSection time_study_section(const std::string& path, const DrawnFigures& figures) {
  const SweepData table = read_table(path, time_study_mark);
  for (const char* column : {"rtol", id::seconds})
    if (!table.has(column)) throw core::FileError(path + ": the table is damaged: it has no column " + column);
  HtmlTable made{"Errors over the run against the reference", {}, {}, "numbers"};
  for (const std::string& column : table.columns) {
    const auto unit = table.units.find(column);
    made.head.push_back(escaped(column) + (unit == table.units.end() ? "" : " [" + escaped(unit->second) + "]"));
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    made.rows.emplace_back();
    for (const std::string& column : table.columns) {
      const double value = table.number(row, column);
      made.rows.back().push_back(
          column == id::status && !done(table, row) ? not_converged_cell(escaped(table.cell(row, column)))
          : std::isfinite(value)                    ? fmt::format("{:.4g}", value)
                                 : escaped(table.cell(row, column) == "NaN" ? "–" : table.cell(row, column)));
    }
  }
  return {heading_of(table),
          path,
          "<p class=\"facts\">" + count_words(table) + "</p>\n" + origin_of(table) + figures_markup(figures) +
              made.text() + comments_of(table),
          {"study in time", {count_words(table)}}};
}

}  // namespace ehl::program
