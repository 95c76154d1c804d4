#include "tables/measured.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/text_table.hpp"
#include "deck/units.hpp"

namespace ehl::program {
namespace {

constexpr double most_srr = 2.0, most_mu = 1.0;

void check(const deck::ColumnRow& row, std::size_t k, double least, double most, const char* what) {
  if (row.values[k] < least || row.values[k] > most)
    throw core::FileError(fmt::format("{}: {:g}: {} must be a number from {:g} to {:g}{}", row.place, row.values[k],
                                      what, least, most,
                                      k == 0   ? "; for values in per cent, use the heading 'SRR [%]'"
                                      : k == 1 ? "; for values in per cent, use the heading 'mu [%]'"
                                               : ""));
}

// True if the table holds films: a column with a unit of length, or with a name of the film.
bool holds_films(const std::string& path) {
  constexpr std::uintmax_t largest = 100'000'000;  // bytes
  const deck::TextTable table = deck::read_text_table(path, largest);
  return std::ranges::any_of(table.heading.cells, [](const std::string& text) {
    const deck::HeadingCell cell = deck::heading_cell(text);
    const deck::Unit* unit = deck::find_unit(cell.unit);
    return (unit != nullptr && std::string_view(unit->si) == "m") || cell.name == "h" ||
           cell.name == numbers::symbol_of(id::hc) || cell.name == numbers::symbol_of(id::hm) || cell.name == "film";
  });
}

}  // namespace

std::vector<MeasuredPoint> read_measured(const std::string& path) {
  const deck::ReadColumns read = deck::read_columns(
      path, {{{"srr", "slide-roll ratio", "slide to roll ratio", "slide roll ratio"}, "-"},
             {{"mu", "friction coefficient", "traction coefficient", "cof", "friction", "traction"}, "-"},
             {{"sigma", "standard error", "standard deviation", "error", "sd"}, "-", false}});
  if (const auto* wrong = std::get_if<std::string>(&read))
    throw core::FileError(
        !holds_films(path)
            ? *wrong
            : path +
                  ": holds films, and measured friction is wanted here: columns srr and mu. Films over speed are "
                  "compared by a sweep over both, e.g. `ehl sweep DECK --vary lubricant.alpha=14e-9:26e-9:4 --vary "
                  "motion.u_m=0.02:1:8:log`, whose column " +
                  numbers::column_in_si(id::hc) + " is to be set against them");
  const auto& table = std::get<deck::ColumnTable>(read);
  std::vector<MeasuredPoint> points;
  for (const deck::ColumnRow& row : table.rows) {
    check(row, 0, -most_srr, most_srr, "the slide-roll ratio");
    check(row, 1, -most_mu, most_mu, "the friction coefficient");
    points.push_back({.srr = row.values[0], .mu = row.values[1]});
    if (!table.present[2]) continue;
    check(row, 2, 1e-9, most_mu, "the standard error");
    points.back().sigma = row.values[2];
  }
  std::ranges::stable_sort(points, {}, &MeasuredPoint::srr);
  return points;
}

}  // namespace ehl::program
