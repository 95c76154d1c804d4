#include "effects/roller/distribution.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::roller {
namespace {

// Integral of P over X of a line contact with the mean load per length.
constexpr double mean_load = 0.5 * core::pi;

Slice slice_at(const core::Grid& grid, const core::Field& P, const core::Field& H, int j) {
  const int centre = static_cast<int>(std::lround(-grid.X_a / grid.hx()));
  Slice slice{.Y = grid.Y(j), .P_max = P(0, j), .H_min = H(0, j), .H_c = H(centre, j)};
  double sum = 0.0;
  for (int i = 0; i <= grid.nx; ++i) {
    sum += P(i, j);
    slice.P_max = std::max(slice.P_max, P(i, j));
    slice.H_min = std::min(slice.H_min, H(i, j));
  }
  slice.load = sum * grid.hx() / mean_load;
  return slice;
}

void add(const Slice& slice, End& end) {
  if (slice.P_max > end.P) end.P = slice.P_max, end.P_Y = slice.Y;
  if (slice.H_min < end.H) end.H = slice.H_min, end.H_Y = slice.Y;
}

}  // namespace

bool near_end(const core::Grid& grid, double Y) {
  constexpr double outer = 0.8 * (1.0 - 1e-9);  // includes a line at exactly 0.8, whatever the rounding
  return std::abs(Y) >= outer * grid.Y_b;
}

Distribution distribution(const core::Grid& grid, const core::Field& P, const core::Field& H) {
  Distribution found;
  found.lower.H = found.upper.H = H(0, 0);
  double load = 0.0, moment = 0.0;
  for (int j = 0; j <= grid.ny; ++j) {
    const Slice slice = slice_at(grid, P, H, j);
    load += slice.load;
    moment += slice.load * slice.Y;
    if (near_end(grid, slice.Y)) add(slice, slice.Y < 0.0 ? found.lower : found.upper);
    found.slices.push_back(slice);
  }
  found.middle = found.slices[static_cast<std::size_t>(grid.ny / 2)];
  found.load_centre = moment / load;
  found.P_at_ends = std::max(found.slices[1].P_max, found.slices[found.slices.size() - 2].P_max);
  return found;
}

}  // namespace ehl::roller
