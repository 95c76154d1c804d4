#pragma once
// Stresses in an elastic half-space below one uniformly loaded rectangle of its surface, in closed form.
//
// The half-space is z >= 0; x, y, z in any common unit, stresses in units of the load, tension positive. The load is a
// pressure p = 1 (sigma_zz = -1 at the surface) or a shear traction q = 1 along +x (tau_xz = -1 at the surface, because
// the outward normal is -z).
#include <array>
#include <cstddef>

namespace ehl::subsurface {

/// Components of a stress, in the order of all arrays.
enum Component { xx, yy, zz, xy, xz, yz };
inline constexpr std::size_t components = 6;
using Stress = std::array<double, components>;

/// Contribution of one corner. The stress below a rectangle is the sum over its four corners of
///   sign * corner(x - x_corner, y - y_corner, z),   sign = + for the corners (left, lower) and (right, upper).
/// in: u, v: offsets from the corner; z >= 0; u, v != 0 if z = 0; nu: Poisson's ratio. out: stresses times 2 pi.
/// limits: each component is even or odd in u and in v, except for terms that cancel in the sum over the corners.
/// source: Love 1929 (potentials of a uniformly loaded rectangle), integrated from Boussinesq's point load.
Stress normal_corner(double u, double v, double z, double nu);
/// Contribution of one corner under q = 1 along x. source: integrated from Cerruti's point load, in the potentials of
/// Johnson, Contact Mechanics (1985), section 3.2.
Stress shear_corner(double u, double v, double z, double nu);

/// Stress at (x, y, z) below a rectangle of 2 half_x by 2 half_y around (0, 0) under p = 1.
Stress normal_patch(double x, double y, double z, double half_x, double half_y, double nu);
/// Stress at (x, y, z) below the same rectangle under q = 1.
Stress shear_patch(double x, double y, double z, double half_x, double half_y, double nu);

/// True for a stress component that is odd in x (in y) below a rectangle under p = 1. Under q = 1 the parity in x is
/// reversed, that in y is the same.
constexpr bool normal_is_odd_in_x(int component) { return component == xy || component == xz; }
constexpr bool is_odd_in_y(int component) { return component == xy || component == yz; }

/// Equivalent stress of von Mises, sqrt(3 J2).
double mises(const Stress& stress);
/// Largest shear stress of all planes, (sigma_1 - sigma_3)/2.
double largest_shear(const Stress& stress);

}  // namespace ehl::subsurface
