#pragma once
// Stresses below a line contact: plane strain, strips of uniform load that have no end along y.
//
// Axes, units and signs are those of patch.hpp: z >= 0 below the surface, tension positive.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"
#include "effects/subsurface/plane_sum.hpp"

namespace ehl::subsurface {

/// Stress at (x, z) below a strip of 2 half_x around x = 0 under p = 1; with t the angle from +x of the direction from
/// a corner, and corner(x - half_x) - corner(x + half_x):
///   2 pi sigma_xx = -(2 t + sin 2t),   2 pi sigma_zz = -(2 t - sin 2t),   2 pi tau_xz = cos 2t,
/// sigma_yy = nu (sigma_xx + sigma_zz). in: z >= 0, z > 0 at x = +-half_x. source: Johnson, Contact Mechanics (1985),
/// section 2.5.
Stress normal_strip(double x, double z, double half_x, double nu);
/// The same under q = 1 along +x, with r the distance from a corner:
///   2 pi sigma_xx = 4 ln r - cos 2t,   2 pi sigma_zz = cos 2t,   2 pi tau_xz = -(2 t + sin 2t).
Stress shear_strip(double x, double z, double half_x, double nu);

/// The plane at depth z below a line contact, cell by cell. in: grid.line; P on its nodes; a cell hx wide lies around
/// every node and carries the node's pressure. out: on the grid's three lines.
/// cost: O(N^2) for N nodes, four products each.
void stress_of_line(const core::Grid& grid, const core::Field& P, const Body& body, double z, StressFields& stress);

}  // namespace ehl::subsurface
