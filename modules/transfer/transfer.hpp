#pragma once
// Transfer of fields between a grid and the grid of every second node. Of a line contact, every second along X: both
// fields have as many lines, and nothing happens along Y.
#include "core/field.hpp"

namespace ehl::transfer {

/// coarse(I,J) = fine(2I,2J), boundary included.
void restrict_injection(const core::Field& fine, core::Field& coarse);

/// Weighted mean of the nine points around entry j of `here`, weights (1 2 1)(1 2 1)/16. in: three rows side by side.
inline double mean_of_nine(const double* west, const double* here, const double* east, int j) {
  const auto across = [j](const double* row) { return row[j - 1] + 2.0 * row[j] + row[j + 1]; };
  return (across(west) + 2.0 * across(here) + across(east)) / 16.0;
}

/// coarse(I,J) = weighted mean of the nine fine points around (2I,2J), weights (1 2 1)(1 2 1)/16;
/// injection on the boundary. in: the patch of `coarse`; `fine` with ghost lines.
void restrict_full_weighting(const core::Patch& grid, const core::Field& fine, core::Field& coarse);

/// Bilinear interpolation. order: 2.
void prolong_bilinear(const core::Field& coarse, core::Field& fine, int threads);

/// Bicubic interpolation, (-1 9 9 -1)/16 along x and then y; beside the boundary the missing value is extrapolated
/// cubically (weights (5 15 -5 1)/16). order: 4, also at the boundary. in: the grid of `coarse`.
/// limits: at least 4 nodes each way on the coarse grid.
void prolong_bicubic(const core::Patch& grid, const core::Field& coarse, core::Field& fine);

}  // namespace ehl::transfer
