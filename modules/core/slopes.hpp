#pragma once
// Derivatives of a field at its nodes by central differences; one-sided at the boundary.
#include <algorithm>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::core {

/// d/dX. in: nx, hx of the grid on which the field is given.
inline double slope_X(const Field& field, int nx, double hx, int i, int j) {
  const int west = std::max(i - 1, 0), east = std::min(i + 1, nx);
  return (field(east, j) - field(west, j)) / ((east - west) * hx);
}

/// d/dY; zero on a line of symmetry.
inline double slope_Y(const Patch& patch, const Field& field, int i, int j) {
  if (patch.north == Edge::mirror && j == patch.ny) return 0.0;
  const int south = std::max(j - 1, 0), north = std::min(j + 1, patch.ny);
  return (field(i, north) - field(i, south)) / ((north - south) * patch.hy());
}

}  // namespace ehl::core
