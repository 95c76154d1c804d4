#pragma once
// Vectors of neighbouring lines on their way into a field.
#include "core/field.hpp"
#include "core/simd.hpp"

namespace ehl::core {

/// Values of the lines j, j + 1, .. at station i. Of a line contact, j <= 1, that of the one line of unknowns on all
/// three: its stations stand so close that a wide vector would reach into the next ones.
inline void store_lines(const Patch& patch, Field& field, int i, int j, Lanes values) {
  if (patch.domain.line)
    fill_lines(field.at_x(i), values[1 - j]);
  else
    store(field.at_x(i) + j, values);
}

}  // namespace ehl::core
