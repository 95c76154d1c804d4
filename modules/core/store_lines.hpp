#pragma once
// Storing vectors of neighbouring lines in a field.
#include "core/field.hpp"
#include "core/simd.hpp"

namespace ehl::core {

/// Stores the lines j, j + 1, .. of column i. For a line contact (j <= 1) the value of the one line of unknowns goes to
/// all three lines, because a wide vector would overwrite the next columns.
inline void store_lines(const Patch& patch, Field& field, int i, int j, Lanes values) {
  if (patch.domain.line)
    fill_lines(field.at_x(i), values[1 - j]);
  else
    store(field.at_x(i) + j, values);
}

}  // namespace ehl::core
