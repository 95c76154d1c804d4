#include "case/map_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/constants.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

/// Largest distance of a coordinate from its grid point, relative to the spacing, that counts as rounding.
constexpr double off_grid = 0.1;

struct Axis {
  double first = 0.0, spacing = 0.0;
  int points = 0;
};

// The regular grid of the coordinates. out: points = 0 if they form no regular grid.
Axis axis_of(std::vector<double> x) {
  std::ranges::sort(x);
  const double range = x.back() - x.front();
  // The spacing is the smallest distance that is not rounding; it is then refined with the whole range.
  constexpr double rounding = 1e-6;
  double least = range;
  for (std::size_t k = 1; k < x.size(); ++k)
    if (const double step = x[k] - x[k - 1]; step > rounding * range) least = std::min(least, step);
  if (!(least > 0.0) || range / least > 1e8) return {};
  const double steps = std::round(range / least);
  const Axis axis{x.front(), range / steps, static_cast<int>(steps) + 1};
  const bool regular = std::ranges::all_of(x, [&](double at) {
    const double place = (at - axis.first) / axis.spacing;
    return std::abs(place - std::round(place)) < off_grid;
  });
  return regular ? axis : Axis{};
}

// The unit of the column called `axis`, "x [um]"; NaN if it is not stated.
double stated_unit(const std::vector<std::string>& heading, char axis) {
  for (const std::string& line : heading) {
    Writing writing;
    writing.separator = line.find(';') != std::string::npos    ? ';'
                        : line.find('\t') != std::string::npos ? '\t'
                        : line.find(',') != std::string::npos  ? ','
                                                               : ' ';
    for (const std::string& cell : cells_of(line, writing))
      if (!cell.empty() && std::tolower(static_cast<unsigned char>(cell[0])) == axis && !in_brackets(cell).empty())
        return metres_of(in_brackets(cell));
  }
  return core::unknown;
}

}  // namespace

double unit_of_coordinates(double spacing, double dx_m, double otherwise) {
  constexpr double close = 0.01;
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9})
    if (std::abs(spacing * unit / dx_m - 1.0) < close) return unit;
  return otherwise;
}

bool is_list(const std::vector<TextLine>& lines) {
  const Writing writing = writing_of(lines);
  return std::ranges::all_of(lines, [&](const TextLine& line) { return cells_of(line.text, writing).size() == 3; });
}

ReadHeights read_list(const std::vector<TextLine>& lines, const std::vector<std::string>& heading,
                      const std::string& name, double dx_m) {
  std::vector<double> x, y, z;
  const std::string wrong = read_numbers(lines, name, [&](const std::vector<double>& row) -> std::string {
    if (std::isnan(row[0] + row[1])) return "a coordinate is missing; a list has x, y and z in every line";
    x.push_back(row[0]);
    y.push_back(row[1]);
    z.push_back(row[2]);
    return {};
  });
  if (!wrong.empty()) return wrong;
  const Axis along = axis_of(x), across = axis_of(y);
  if (along.points == 0 || across.points == 0)
    return name + ": its x and y are not those of a regular grid: put the points on one with Gwyddion";
  const double nodes = static_cast<double>(along.points) * across.points;
  constexpr double most_nodes_per_point = 4.0;
  if (nodes > most_nodes_per_point * static_cast<double>(z.size()))
    return fmt::format("{}: {} points on a grid of {} x {}: too many are missing", name, z.size(), along.points,
                       across.points);
  MapInFile map;
  map.heights = {along.points, across.points, std::vector<double>(static_cast<std::size_t>(nodes), core::unknown)};
  std::vector<bool> taken(map.heights.values.size());
  for (std::size_t n = 0; n < z.size(); ++n) {
    const auto k = static_cast<int>(std::lround((x[n] - along.first) / along.spacing));
    const auto l = static_cast<int>(std::lround((y[n] - across.first) / across.spacing));
    const std::size_t at =
        static_cast<std::size_t>(l) * static_cast<std::size_t>(along.points) + static_cast<std::size_t>(k);
    if (taken[at]) return fmt::format("{}:{}: this point occurs twice", name, lines[n].number);
    taken[at] = true;
    map.heights.values[at] = z[n];
  }
  const double stated = stated_unit(heading, 'x');
  const double unit = std::isnan(stated) ? unit_of_coordinates(along.spacing, dx_m, core::unknown) : stated;
  map.dx_m = along.spacing * unit;
  map.dy_m = across.spacing * unit;
  map.unit_m = stated_unit(heading, 'z');
  if (std::isnan(unit) && !std::isnan(dx_m))
    return fmt::format(
        "{}: its points are {:.6g} apart along x, which in none of the units m, mm, um and nm is the distance {:.6g} m "
        "of the deck",
        name, along.spacing, dx_m);
  return map;
}

}  // namespace ehl::program
