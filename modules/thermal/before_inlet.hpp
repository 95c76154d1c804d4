#pragma once
// What a body of a line contact has taken up before it comes to the first node.
#include <vector>

#include "core/grid.hpp"

namespace ehl::thermal {

/// E_i, so that E_i q_0 is the temperature that the heat of all X < X_a makes of node i: q_0 the flux into the body at
/// the first node, upstream of it q = q_0 (X_a/X)^3. Shear makes heat as X^-2, of which the oil that recirculates takes
/// its part along; with the second power Hc came out too small for 37 of 39 contacts, with the third for 22. in:
/// marched, what a cell makes of the nodes downstream of it, by distance in cells; Pe > 0 of the body; factor of
/// marched. Beyond the last of them a moving line source (Carslaw and Jaeger).
std::vector<double> before_inlet(const core::Patch& line, const std::vector<double>& marched, double Pe, double factor);

}  // namespace ehl::thermal
