#include "tables/measured.hpp"

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr double most_srr = 2.0, most_mu = 1.0;

double number_in(const deck::Row& row, std::size_t k, double least, double most, const char* what) {
  const deck::ReadNumber read = deck::read_number(row.cells[k]);
  if (read.status != deck::ReadNumber::Status::number || read.value < least || read.value > most)
    throw core::FileError(row.place + ": " + row.cells[k] + ": " + what + " must be a number from " +
                          deck::shortest(least) + " to " + deck::shortest(most));
  return read.value;
}

}  // namespace

std::vector<MeasuredPoint> read_measured(const std::string& path) {
  std::vector<MeasuredPoint> points;
  std::size_t columns = 0;
  for (const deck::Row& row : deck::rows_of(path)) {
    if (row.cells.size() < 2 || row.cells.size() > 3 || (columns != 0 && row.cells.size() != columns))
      throw core::FileError(row.place +
                            ": a row is a slide-roll ratio and a friction coefficient, and in all rows or " +
                            "in none the standard error of the coefficient");
    columns = row.cells.size();
    points.push_back({.srr = number_in(row, 0, -most_srr, most_srr, "the slide-roll ratio (not in per cent)"),
                      .mu = number_in(row, 1, -most_mu, most_mu, "the friction coefficient")});
    if (columns == 3) points.back().sigma = number_in(row, 2, 1e-9, most_mu, "the standard error");
  }
  if (points.empty()) throw core::FileError(path + ": there is no row in it");
  std::ranges::stable_sort(points, {}, &MeasuredPoint::srr);
  return points;
}

}  // namespace ehl::program
