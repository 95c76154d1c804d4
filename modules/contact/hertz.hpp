#pragma once
// The dry circular contact of Hertz: the scales of everything dimensionless.
namespace ehl::contact {

/// One body: E [Pa] > 0, nu in (-1, 0.5].
struct Elastic {
  double E;
  double nu;
};

/// E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2].
/// in: two bodies. out: [Pa]. limits: one body rigid (E = infinity) gives 2 E/(1 - nu^2) of the other.
double reduced_modulus(const Elastic& first, const Elastic& second);

/// Circular contact: the pressure is p_h sqrt(1 - (r/a)^2) inside the radius a.
struct Hertz {
  double a;         ///< radius of the contact [m]
  double p_h;       ///< maximum pressure [Pa]
  double approach;  ///< a^2/R, mutual approach of distant points [m]
  double h_scale;   ///< a^2/R, the film thickness of H = 1 [m]
};

/// a^3 = 3 F R/(2 E'), p_h = 3 F/(2 pi a^2), approach = a^2/R.
/// in: load F [N] > 0, radius R of the equivalent ball on a plane [m] > 0, E_prime [Pa] > 0 in the convention
/// of reduced_modulus. source: Hertz (1881).
Hertz hertz(double load, double radius, double E_prime);

}  // namespace ehl::contact
