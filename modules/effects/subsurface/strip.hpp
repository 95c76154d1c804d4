#pragma once
// Stresses below a line contact (plane strain): uniformly loaded strips of infinite length along y.
//
// Axes, units and signs as in patch.hpp: z >= 0 below the surface, tension positive.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "effects/subsurface/patch.hpp"
#include "effects/subsurface/plane_kernel.hpp"
#include "effects/subsurface/plane_sum.hpp"

namespace ehl::subsurface {

/// Stress at (x, z) below a strip of width 2 half_x around x = 0 under p = 1: corner(x - half_x) - corner(x + half_x).
/// With t the angle of the direction from the corner, measured from +x, a corner contributes
///   2 pi sigma_xx = -(2 t + sin 2t),   2 pi sigma_zz = -(2 t - sin 2t),   2 pi tau_xz = cos 2t,
/// sigma_yy = nu (sigma_xx + sigma_zz). in: z >= 0; z > 0 at x = +-half_x. source: Johnson, Contact Mechanics (1985),
/// section 2.5.
Stress normal_strip(double x, double z, double half_x, double nu);
/// Stress below the same strip under q = 1 along +x, r the distance from the corner:
///   2 pi sigma_xx = 4 ln r - cos 2t,   2 pi sigma_zz = cos 2t,   2 pi tau_xz = -(2 t + sin 2t).
Stress shear_strip(double x, double z, double half_x, double nu);

/// Stresses at depth z below one cell of a line contact at the offsets -nx..nx cells, under p = 1 and under q = 1.
struct StripKernel {
  StripKernel(const core::Grid& grid, double nu, double z);
  double nu;
  std::vector<double> under[loads][components];  ///< sigma_xx, sigma_zz, tau_xz; the others are empty
};

/// Stresses in a plane below a line contact, by direct summation. in: grid.line; P on its nodes; each node has a cell
/// of width hx around it that carries its pressure; friction: shear traction along +x over pressure. out: on the grid's
/// three lines. cost: O(N^2) for N nodes, three products each.
void stress_of_line(const StripKernel& kernel, const core::Grid& grid, const core::Field& P, double friction,
                    StressFields& stress);

}  // namespace ehl::subsurface
