#pragma once
// The dry contact of Hertz, on whose scales all dimensionless quantities are based.
#include "contact/ellipse.hpp"
#include "kernel/coating.hpp"

namespace ehl::contact {

using Elastic = kernel::Material;

/// E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2].
/// in: two bodies. out: [Pa]. limits: if one body is rigid (E = infinity), 2 E/(1 - nu^2) of the other.
double reduced_modulus(const Elastic& first, const Elastic& second);

/// The pressure is p_h sqrt(1 - (x/a)^2 - (y/b)^2), x along the radius R_x and y along R_y.
struct Hertz {
  double a;         ///< semi-axis along R_x, the radius of a circular contact [m]
  double p_h;       ///< maximum pressure [Pa]
  double approach;  ///< mutual approach of distant points [m]; a^2/R for a circular contact
  double h_scale;   ///< a^2/R_x, the film thickness for H = 1 [m]
  double b;         ///< semi-axis along R_y [m]
};

/// Circle: a^3 = 3 F R/(2 E'), p_h = 3 F/(2 pi a^2), approach = a^2/R; other shapes by contact/ellipse.hpp.
/// in: load F [N] > 0, for a line contact per length [N/m]; radius R_x [m] > 0 (circular contact: of the equivalent
/// ball on a plane); E_prime [Pa] > 0 as defined by reduced_modulus(). source: Hertz (1881).
Hertz hertz(double load, double radius, double E_prime, const Ellipse& shape = {});

}  // namespace ehl::contact
