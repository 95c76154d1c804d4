#pragma once
// Transfer of fields between a grid and the grid of every second node. A direction in which both fields have the same
// number of nodes is kept: Y in a line contact, X where a grid is coarsened along Y alone.
#include "core/field.hpp"

namespace ehl::transfer {

/// coarse(I,J) = fine(2I,2J), including the boundary; fine(2I,J) or fine(I,2J) where a direction is kept.
void restrict_injection(const core::Field& fine, core::Field& coarse);

/// Weighted mean of the nine points around entry j of `here`, weights (1 2 1)(1 2 1)/16. in: three neighbouring rows.
inline double mean_of_nine(const double* west, const double* here, const double* east, int j) {
  const auto across = [j](const double* row) { return row[j - 1] + 2.0 * row[j] + row[j + 1]; };
  return (across(west) + 2.0 * across(here) + across(east)) / 16.0;
}

/// Weighted mean of the three points around entry j of a row, weights (1 2 1)/4.
inline double mean_of_three(const double* here, int j) { return (here[j - 1] + 2.0 * here[j] + here[j + 1]) / 4.0; }

/// coarse(I,J) = weighted mean of the nine fine points around (2I,2J), weights (1 2 1)(1 2 1)/16; where X is kept, of
/// the three points along Y, weights (1 2 1)/4. Injection on the boundary. in: the patch of `coarse`; `fine` with ghost
/// lines.
void restrict_full_weighting(const core::Patch& grid, const core::Field& fine, core::Field& coarse);

/// Bilinear interpolation; linear along Y where X is kept. order: 2.
void prolong_bilinear(const core::Field& coarse, core::Field& fine, int threads);

/// Bicubic interpolation, (-1 9 9 -1)/16 along X and then along Y. Next to the boundary the missing value is
/// extrapolated cubically, which gives the weights (5 15 -5 1)/16. order: 4, also at the boundary. in: the grid of
/// `coarse`. limits: at least 4 nodes in each direction on the coarse grid.
void prolong_bicubic(const core::Patch& grid, const core::Field& coarse, core::Field& fine);

}  // namespace ehl::transfer
