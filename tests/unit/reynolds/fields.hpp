#pragma once
// The fields of a Reynolds equation, owned.
#include "reynolds/residual.hpp"
#include "support/random.hpp"

namespace ehl::tests {

struct Fields {
  core::Field P, H, rho_bar, eps, f;
  reynolds::Face face = reynolds::Face::mean;
  reynolds::Fields state() const { return {P, H, rho_bar, eps, f, eps, face}; }
};

inline Fields zero_fields(const core::Patch& grid) {
  return {core::Field(grid), core::Field(grid), core::Field(grid), core::Field(grid), core::Field(grid)};
}

/// Values of every size that they have in a contact, without any smoothness; the boundary's too.
inline Fields random_fields(const core::Patch& grid, Random& random) {
  return {random_field(grid, random, -0.1, 1.0), random_field(grid, random, 0.0, 2.0),
          random_field(grid, random, 1.0, 1.3), random_field(grid, random, 0.0, 3.0),
          random_field(grid, random, -1.0, 1.0)};
}

}  // namespace ehl::tests
