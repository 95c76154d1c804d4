#pragma once
// The fields of a Reynolds equation, with their storage.
#include <algorithm>

#include "reynolds/residual.hpp"
#include "support/random.hpp"

namespace ehl::tests {

struct Fields {
  core::Field P, H, rho_bar, eps, f;
  core::Field third_order;  ///< theta at the faces downstream of the nodes along X
  reynolds::Face face = reynolds::Face::mean;
  reynolds::Fields state() const { return {P, H, rho_bar, eps, f, eps, face, third_order}; }
};

inline Fields zero_fields(const core::Patch& grid) {
  return {core::Field(grid), core::Field(grid), core::Field(grid),
          core::Field(grid), core::Field(grid), core::Field(grid)};
}

/// Rough random fields with values of the sizes that occur in a contact, including the boundary.
inline Fields random_fields(const core::Patch& grid, Random& random) {
  Fields fields{random_field(grid, random, -0.1, 1.0), random_field(grid, random, 0.0, 2.0),
                random_field(grid, random, 1.0, 1.3),  random_field(grid, random, 0.0, 3.0),
                random_field(grid, random, -1.0, 1.0), random_field(grid, random, 0.0, 1.0)};
  std::ranges::fill(fields.third_order.station(0), 0.0);  // the first face has no third node
  return fields;
}

}  // namespace ehl::tests
