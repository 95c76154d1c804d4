#include "surface/resample.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ehl::surface {
namespace {

/// Points on each side that the cubic convolution uses.
constexpr double reach = 2.0;

// Integral from 0 to u of Keys' kernel, 1 - 5/2 u^2 + 3/2 u^3 up to 1 and 2 - 4 u + 5/2 u^2 - 1/2 u^3 up to 2.
double integral_of_kernel(double u) {
  const double v = std::abs(u);
  double value = 0.5;
  if (v < 1.0)
    value = v * (1.0 - v * v * (5.0 / 6.0 - 3.0 / 8.0 * v));
  else if (v < reach)
    value = v * (2.0 - v * (2.0 - v * (5.0 / 6.0 - v / 8.0))) - 1.0 / 6.0;
  return u < 0.0 ? -value : value;
}

/// Points that contribute to the mean over a cell, and their weights.
struct Mean {
  int first = 0;
  std::vector<double> weights{};
};

// in: middle and cell, centre and length of the cell in steps of the map, with the first point at 0; points along the
// axis.
Mean mean_over_cell(double middle, double cell, int points) {
  Mean mean;
  mean.first = static_cast<int>(std::clamp(std::ceil(middle - 0.5 * cell - reach), 0.0, static_cast<double>(points)));
  const double most = std::min<double>(points, middle + 0.5 * cell + reach);
  for (int k = mean.first; k <= most && k < points; ++k)
    mean.weights.push_back((integral_of_kernel(middle + 0.5 * cell - k) - integral_of_kernel(middle - 0.5 * cell - k)) /
                           cell);
  return mean;
}

// Averages the map along y, for each of its columns.
void average_along_y(const Heights& heights, const Mean& mean, std::vector<double>& stations) {
  std::ranges::fill(stations, 0.0);
  for (std::size_t n = 0; n < mean.weights.size(); ++n)
    for (int k = 0; k < heights.nx; ++k)
      stations[static_cast<std::size_t>(k)] += mean.weights[n] * heights(k, mean.first + static_cast<int>(n));
}

double average_along_x(const std::vector<double>& stations, const Mean& mean) {
  double sum = 0.0;
  for (std::size_t n = 0; n < mean.weights.size(); ++n)
    sum += mean.weights[n] * stations[static_cast<std::size_t>(mean.first) + n];
  return sum;
}

// The map averaged over cells of the mesh's size, at its own points.
Heights averaged(const HeightMap& map, const core::Patch& grid) {
  const auto means = [](int points, double cell) {
    std::vector<Mean> all;
    for (int k = 0; k < points; ++k) all.push_back(mean_over_cell(k, cell, points));
    return all;
  };
  const std::vector<Mean> of_x = means(map.gap.nx, grid.hx() / map.dx);
  const std::vector<Mean> of_y = means(map.gap.ny, grid.hy() / map.dy);
  std::vector<double> stations(of_x.size());
  Heights result = map.gap;
  for (int l = 0; l < map.gap.ny; ++l) {
    average_along_y(map.gap, of_y[static_cast<std::size_t>(l)], stations);
    for (int k = 0; k < map.gap.nx; ++k) result(k, l) = average_along_x(stations, of_x[static_cast<std::size_t>(k)]);
  }
  return result;
}

}  // namespace

void add_average(const HeightMap& map, const core::Patch& grid, double distance, core::Field& S) {
  const double left = map.X + distance - 0.5 * map.length_x();
  const double lower = map.Y - 0.5 * map.length_y();
  std::vector<Mean> of_x;
  for (int i = 0; i <= grid.nx; ++i)
    of_x.push_back(mean_over_cell((grid.X(i) - left) / map.dx, grid.hx() / map.dx, map.gap.nx));
  std::vector<double> stations(static_cast<std::size_t>(map.gap.nx));
  for (int j = 0; j <= grid.ny; ++j) {
    const Mean of_y = mean_over_cell((grid.Y(j) - lower) / map.dy, grid.hy() / map.dy, map.gap.ny);
    if (of_y.weights.empty()) continue;
    average_along_y(map.gap, of_y, stations);
    for (int i = 0; i <= grid.nx; ++i) S(i, j) += average_along_x(stations, of_x[static_cast<std::size_t>(i)]);
  }
}

Resolution resolution(const HeightMap& map, const core::Patch& grid) {
  const double before = rms(map.gap);
  const double after = rms(averaged(map, grid));
  return {.variance_lost = std::max(0.0, 1.0 - after * after / (before * before)),
          .shortest_wave_X = 2.0 * std::max(grid.hx(), map.dx),
          .shortest_wave_Y = 2.0 * std::max(grid.hy(), map.dy)};
}

}  // namespace ehl::surface
