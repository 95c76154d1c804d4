#pragma once
// What a solution with touching surfaces says about their contact.
#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::mixed {

/// The contact of touching surfaces.
struct Contact {
  double share = 0.0;  ///< of the load, carried by P_c
  double area = 0.0;   ///< where P_c > 0, over that of the smooth dry contact
  int patches = 0;     ///< number of separate regions with P_c > 0; nodes that meet at a corner belong together
  double P_c_max = 0.0;
  double X = 0.0, Y = 0.0;  ///< the place of P_c_max
};

/// in: P_c on the whole domain; load: of the contact; area: of the smooth dry contact, in a^2; of a line contact both
/// per length. cost: two visits of every node.
Contact contact_of(const core::Grid& grid, const core::Field& P_c, double load, double area);

}  // namespace ehl::mixed
