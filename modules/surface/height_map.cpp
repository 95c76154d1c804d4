#include "surface/height_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ehl::surface {
namespace {

/// Largest difference between symmetric points, over the largest height, that counts as rounding.
constexpr double rounding = 1e-12;

// Factors of the taper along an axis of n points.
std::vector<double> window(int n, double share) {
  const double margin = std::max(1.0, share * (n - 1));
  std::vector<double> factors;
  for (int k = 0; k < n; ++k) {
    const double s = std::min(k, n - 1 - k) / margin;
    factors.push_back(s < 1.0 ? 0.5 * (1.0 - std::cos(std::numbers::pi * s)) : 1.0);
  }
  return factors;
}

}  // namespace

// With the origin at the centre, the three least-squares equations are independent.
Plane level(Heights& heights) {
  const double mid_x = 0.5 * (heights.nx - 1);
  const double mid_y = 0.5 * (heights.ny - 1);
  double sum = 0.0, with_x = 0.0, with_y = 0.0, xx = 0.0, yy = 0.0;
  for (int l = 0; l < heights.ny; ++l)
    for (int k = 0; k < heights.nx; ++k) {
      const double x = k - mid_x;
      const double y = l - mid_y;
      sum += heights(k, l);
      with_x += x * heights(k, l);
      with_y += y * heights(k, l);
      xx += x * x;
      yy += y * y;
    }
  const Plane plane{sum / static_cast<double>(heights.values.size()), with_x / xx, with_y / yy};
  for (int l = 0; l < heights.ny; ++l)
    for (int k = 0; k < heights.nx; ++k)
      heights(k, l) -= plane.mean + plane.slope_x * (k - mid_x) + plane.slope_y * (l - mid_y);
  return plane;
}

Plane level_mean(Heights& heights) {
  double sum = 0.0;
  for (const double height : heights.values) sum += height;
  const Plane plane{.mean = sum / static_cast<double>(heights.values.size())};
  for (double& height : heights.values) height -= plane.mean;
  return plane;
}

void taper(Heights& heights, double share) {
  if (share == 0.0) return;
  const std::vector<double> along = window(heights.nx, share);
  const std::vector<double> across = window(heights.ny, share);
  for (int l = 0; l < heights.ny; ++l)
    for (int k = 0; k < heights.nx; ++k)
      heights(k, l) *= along[static_cast<std::size_t>(k)] * across[static_cast<std::size_t>(l)];
}

double rms(const Heights& heights) {
  double sum = 0.0;
  for (const double height : heights.values) sum += height * height;
  return std::sqrt(sum / static_cast<double>(heights.values.size()));
}

double mean_height(const Heights& heights) {
  double sum = 0.0;
  for (const double height : heights.values) sum += std::abs(height);
  return sum / static_cast<double>(heights.values.size());
}

bool symmetric(const HeightMap& map) {
  if (map.Y != 0.0) return false;
  double largest = 0.0, apart = 0.0;
  for (int l = 0; l < map.gap.ny; ++l)
    for (int k = 0; k < map.gap.nx; ++k) {
      largest = std::max(largest, std::abs(map.gap(k, l)));
      apart = std::max(apart, std::abs(map.gap(k, l) - map.gap(k, map.gap.ny - 1 - l)));
    }
  return apart <= rounding * largest;
}

}  // namespace ehl::surface
