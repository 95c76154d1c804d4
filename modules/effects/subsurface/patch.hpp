#pragma once
// Stresses in an elastic half space below one rectangle of its surface under a uniform load: closed forms.
//
// The half space is z >= 0, its surface z = 0; x, y, z in any one unit, stresses in units of the load. Tension is
// positive. The load presses with p = 1 (surface sigma_zz = -1 below it) or pulls with q = 1 along +x (surface
// tau_xz = -1 below it: the outward normal is -z).
#include <array>
#include <cstddef>

namespace ehl::subsurface {

/// The six components of a stress, in the order in which arrays hold them.
enum Component { xx, yy, zz, xy, xz, yz };
inline constexpr std::size_t components = 6;
using Stress = std::array<double, components>;

/// What one corner of the rectangle contributes: the stress below a rectangle is the sum over its four corners of
/// sign * corner(x - x_corner, y - y_corner, z), signs + for the corners (left, lower) and (right, upper).
/// in: u, v offsets from the corner, z >= 0, not all of one pair of them zero: u, v != 0 where z = 0; nu: Poisson's
/// ratio. out: stresses times 2 pi. limits: every component is even or odd in u and in v up to terms that the sum
/// over the corners loses.
/// source: Love 1929 (potentials of a uniformly loaded rectangle), integrated from Boussinesq's point load.
Stress normal_corner(double u, double v, double z, double nu);
/// The same for the shear along x. source: integrated from Cerruti's point load, in the potentials of Johnson, Contact
/// Mechanics (1985), section 3.2.
Stress shear_corner(double u, double v, double z, double nu);

/// Stress at (x, y, z) below a rectangle of 2 half_x by 2 half_y around (0, 0) under p = 1.
Stress normal_patch(double x, double y, double z, double half_x, double half_y, double nu);
/// The same under q = 1.
Stress shear_patch(double x, double y, double z, double half_x, double half_y, double nu);

/// True where a component of the stress below a rectangle under p = 1 changes its sign with x (with y). Under q = 1
/// it is the other way round in x, the same in y.
constexpr bool normal_is_odd_in_x(int component) { return component == xy || component == xz; }
constexpr bool is_odd_in_y(int component) { return component == xy || component == yz; }

/// sqrt(3 J2): the equivalent stress of von Mises.
double mises(const Stress& stress);
/// (sigma_1 - sigma_3)/2: the largest shear stress of all planes.
double largest_shear(const Stress& stress);

}  // namespace ehl::subsurface
