#pragma once
// Heat that a body of a line contact takes up upstream of the first node.
#include <vector>

#include "core/grid.hpp"

namespace ehl::thermal {

/// E_i: E_i q_0 is the temperature that the heat of all X < X_a causes at node i. q_0 is the flux into the body at the
/// first node; upstream q = q_0 (X_a/X)^3, because shear heating decays as X^-2 and recirculating oil carries part of
/// it away. [bench: before_inlet_power]
/// in: marched: temperature that unit flux into a cell causes at the nodes downstream, by distance in cells; Pe > 0 of
/// the body; factor of marched. Beyond these cells a moving line source is used (Carslaw and Jaeger).
std::vector<double> before_inlet(const core::Patch& line, const std::vector<double>& marched, double Pe, double factor);

}  // namespace ehl::thermal
