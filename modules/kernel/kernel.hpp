#pragma once
// The elastic kernel of a contact as a value: half-space, half-plane, or either with coatings on the bodies.
#include <vector>

#include "core/constants.hpp"
#include "kernel/coating.hpp"
#include "kernel/influence.hpp"

namespace ehl::kernel {

/// Eq. (6): the deformation of a circular contact, in units of a^2/R for a pressure in units of p_h, is this factor
/// times K*P.
inline constexpr double circular_factor = 2.0 / (core::pi * core::pi);

/// The deformation is factor K*P. K is 1/r (half-space, points) or -ln|x| (half-plane, lines), and what the coatings
/// add to it. `factor` is that of the uncoated bodies, and so that of K far
/// away. Lines: K vanishes at the distance 1.
struct Kernel {
  bool plane = false;
  double factor = circular_factor;
  std::vector<SmoothPart> coatings{};  ///< made for `plane`
};
inline Kernel half_space(double factor = circular_factor) { return {.plane = false, .factor = factor}; }
inline Kernel half_plane(double factor) { return {.plane = true, .factor = factor}; }

/// What the coatings add to K at the distance r > 0 of a point or line load.
double by_coatings(const Kernel& kernel, double r);
/// K at the distance r > 0.
double at_distance(const Kernel& kernel, double r);

/// Influence coefficients as in influence.hpp, without the factor. With coatings, the smooth parts are integrated by
/// Gauss' rule over the cell, which is divided where it is large compared with its distance and with the thickness.
/// limits: that of influence.hpp, and the error of SmoothPart. Delta K is only for offsets of a few cells if there are
/// coatings, since it is a plain difference of K.
double influence(const Kernel& kernel, int d_x, int d_y, double hx, double hy);
double distributed_influence(const Kernel& kernel, int d_x, int d_y, double hx, double hy);
InfluenceTable influence_table(const Kernel& kernel, int n_x, int n_y, double hx, double hy, int every_x = 1,
                               int every_y = 1);
double line_influence(const Kernel& kernel, int d, double hx);
double distributed_line_influence(const Kernel& kernel, int d, double hx);
std::vector<double> line_influence_table(const Kernel& kernel, int n, double hx, int every = 1);

}  // namespace ehl::kernel
