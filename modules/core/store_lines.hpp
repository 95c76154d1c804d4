#pragma once
// Lines of a field as vectors: neighbouring lines in the lanes, and the one line of a line contact.
#include <span>

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

/// The values on the one line of a line contact. in: out has as many values as the field has columns, or fewer.
inline void load_line(const Field& field, std::span<double> out) {
  const double* own = field.at_x(0) + 1;
  for (double& value : out) {
    value = *own;
    own += field.stride();
  }
}

/// Stores values on the one line of a line contact, from column `first` on.
inline void store_line(std::span<const double> values, Field& field, int first = 0) {
  double* station = field.at_x(first);
  for (const double value : values) {
    fill_lines(station, value);
    station += field.stride();
  }
}

}  // namespace ehl::core
