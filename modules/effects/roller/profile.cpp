#include "effects/roller/profile.hpp"

#include <algorithm>
#include <cmath>

namespace ehl::roller {

double drop(const Profile& profile, double Y) {
  const double half = 0.5 * profile.length;
  switch (profile.shape) {
    case Profile::Shape::straight: {
      const double beyond = std::max(0.0, std::abs(Y) - (half - profile.end_length));
      return 0.5 * beyond * beyond / profile.end_radius;
    }
    case Profile::Shape::crowned: return 0.5 * Y * Y / profile.crown_radius;
    case Profile::Shape::logarithmic: {
      const double Q = profile.design_load;
      const double short_of_end = 0.6066 * std::sqrt(Q) / profile.length;
      const double y = Y / half;
      return -0.25 * Q * std::log(1.0 - (1.0 - short_of_end) * y * y);
    }
    case Profile::Shape::table: break;
  }
  return profile.table(Y);
}

void add_gap(const Profile& profile, const core::Patch& grid, core::Field& S) {
  for (int j = 0; j <= grid.ny; ++j) {
    const double gap = drop(profile, grid.Y(j)) + profile.tilt * grid.Y(j);
    for (int i = 0; i <= grid.nx; ++i) S(i, j) += gap;
  }
}

bool symmetric(const Profile& profile) {
  if (profile.tilt != 0.0) return false;
  if (profile.shape != Profile::Shape::table) return true;
  constexpr int parts = 1000;
  constexpr double rounding = 1e-9;
  for (int k = 0; k <= parts; ++k) {
    const double Y = 0.5 * profile.length * k / parts;
    const double here = drop(profile, Y), there = drop(profile, -Y);
    if (std::abs(here - there) > rounding * std::max(std::abs(here), std::abs(there))) return false;
  }
  return true;
}

}  // namespace ehl::roller
