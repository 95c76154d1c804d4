#pragma once
// The values of a field on the lines j, j+2, .. of a batch in one column.
#include "core/field.hpp"
#include "core/simd.hpp"

namespace ehl::multigrid {

/// The values of the lines, and of the lines before (south) and after (north) them.
struct Beside {
  core::Lanes south, own, north;
};
/// The values of the lines j, j+2, .. in column i.
inline core::Lanes own_lines(const core::Field& field, int i, int j) {
  const double* p = field.at_x(i) + j;
  return core::evens(core::load(p), core::load(p + core::lanes));
}
/// The values of the lines j, j+2, .. in column i, and of the lines before and after each of them.
inline Beside with_neighbours(const core::Field& field, int i, int j) {
  const double* p = field.at_x(i) + j;
  const core::Lanes low = core::load(p);
  const core::Lanes high = core::load(p + core::lanes);
  return {core::evens(core::load(p - 1), core::load(p + core::lanes - 1)), core::evens(low, high),
          core::odds(low, high)};
}

}  // namespace ehl::multigrid
