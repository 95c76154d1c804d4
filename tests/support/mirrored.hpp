#pragma once
// Fields that are symmetric in Y, on the whole domain and on its lower half.
#include <algorithm>

#include "core/norms.hpp"
#include "support/random.hpp"

namespace ehl::tests {

/// The lower half of a symmetric field, including ghost lines.
inline core::Field half_of(const core::Grid& whole, const core::Field& field) {
  const core::Patch half_grid = core::lower_half(whole);
  core::Field half = core::on_patch(half_grid, field);
  core::fill_ghosts(half_grid, half);
  return half;
}

/// A random field that is symmetric in Y, and its lower half.
struct SymmetricField {
  core::Field whole, half;
};
inline SymmetricField symmetric_field(const core::Grid& whole, Random& random, double low, double high) {
  core::Field field = random_field(whole, random, low, high);
  for (int i = 0; i <= whole.nx; ++i)
    for (int j = 0; 2 * j < whole.ny; ++j) field(i, whole.ny - j) = field(i, j);
  core::Field half = half_of(whole, field);
  return {std::move(field), std::move(half)};
}

/// Largest difference between a field on the whole domain and one on its lower half.
inline double difference_of_half(const core::Grid& whole, const core::Field& field, const core::Field& half) {
  return core::max_abs_difference(field, core::on_domain(core::lower_half(whole), half));
}

}  // namespace ehl::tests
