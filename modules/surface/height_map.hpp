#pragma once
// A measured surface: heights on a grid of points, made ready to be carried by a smooth body.
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

/// mean + slope_x k + slope_y l, k and l counted from the middle of the map.
struct Plane {
  double mean = 0.0;
  double slope_x = 0.0;  ///< per point
  double slope_y = 0.0;
};

/// Takes away the plane of least squares and returns it: the bodies' approach and alignment belong to H00, not to the
/// surface. limits: nx, ny >= 2. errors: exact but for rounding for a map that is a plane.
Plane level(Heights& heights);

/// Takes the mean alone away and returns it, with slopes of 0.
Plane level_mean(Heights& heights);

/// Multiplies by (1 - cos(pi s))/2 where a point is a part s < 1 of the margin away from an edge, along both axes;
/// margin = share of the map's length, at least one step. The map ends at zero and without a kink.
/// in: 0 <= share <= 0.5; 0: nothing is done.
void taper(Heights& heights, double share);

/// Root of the mean square, Sq of heights without mean.
double rms(const Heights& heights);
/// Mean of the absolute heights, Sa.
double mean_height(const Heights& heights);

/// A map as it is carried: lengths in Hertz radii, what the gap gains in a^2/R (the other sign of the height of the
/// surface). Outside of the points it is zero.
struct HeightMap {
  Heights gap{};
  double dx = 0.0;  ///< between the points
  double dy = 0.0;
  double X = 0.0;  ///< of the middle at T = 0
  double Y = 0.0;
  double step = 0.0;  ///< longest distance that it may move in one step of time

  double length_x() const { return (gap.nx - 1) * dx; }
  double length_y() const { return (gap.ny - 1) * dy; }
};

/// True where S(X, Y) = S(X, -Y), but for rounding.
bool symmetric(const HeightMap& map);

}  // namespace ehl::surface
