#pragma once
// A measured surface: heights on a grid of points, prepared for a smooth body.
#include <cstddef>
#include <vector>

namespace ehl::surface {

/// Heights at nx by ny points, x fastest.
struct Heights {
  int nx = 0;
  int ny = 0;
  std::vector<double> values{};

  double& operator()(int k, int l) {
    return values[static_cast<std::size_t>(l) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(k)];
  }
  double operator()(int k, int l) const {
    return values[static_cast<std::size_t>(l) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(k)];
  }
};

/// mean + slope_x k + slope_y l, with k and l counted from the centre of the map.
struct Plane {
  double mean = 0.0;
  double slope_x = 0.0;  ///< per point
  double slope_y = 0.0;
};

/// Subtracts the least-squares plane and returns it; approach and alignment of the bodies belong to H00. limits: nx, ny
/// >= 2. error: rounding for a map that is a plane.
Plane level(Heights& heights);

/// Subtracts only the mean and returns it, with slopes of 0.
Plane level_mean(Heights& heights);

/// Multiplies by (1 - cos(pi s))/2 at points whose distance to an edge is a part s < 1 of the margin, along both axes.
/// margin = share of the length of the map, at least one step. The map then ends at zero with zero slope.
/// in: 0 <= share <= 0.5; 0: no change.
void taper(Heights& heights, double share);

/// Root mean square, Sq of heights with zero mean.
double rms(const Heights& heights);
/// Mean of the absolute heights, Sa.
double mean_height(const Heights& heights);

/// A map ready for use: lengths in Hertz radii, contribution to the gap in a^2/R (heights with opposite sign); zero
/// outside the points.
struct HeightMap {
  Heights gap{};
  double dx = 0.0;  ///< between the points
  double dy = 0.0;
  double X = 0.0;  ///< of the centre at T = 0
  double Y = 0.0;
  double step = 0.0;  ///< longest distance that it may move in one time step

  double length_x() const { return (gap.nx - 1) * dx; }
  double length_y() const { return (gap.ny - 1) * dy; }
};

/// True if S(X, Y) = S(X, -Y) up to rounding.
bool symmetric(const HeightMap& map);

}  // namespace ehl::surface
