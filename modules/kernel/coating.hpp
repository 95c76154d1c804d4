#pragma once
// An elastic coating bonded to a body: its response to a wave of normal pressure, and what it adds to the influence of
// a point or line load.
#include <vector>

namespace ehl::kernel {

/// An isotropic material: Young's modulus, in one unit for all materials of a contact; nu in (-1, 0.5].
struct Material {
  double E;
  double nu;
};

/// A coating on one of the two bodies of a contact.
struct Coating {
  Material coating;
  Material body;
  double thickness;  ///< t > 0, in the unit of length of the cells
  double share;      ///< of the body in the compliance of the uncoated contact, (E'/2)(1 - nu^2)/E; both add up to 1
};

/// R(q), q = k t: the surface displacement of the coated body under a pressure cos(k x), relative to that of the body
/// without its coating, minus 1. It vanishes for q -> 0, and tends to local_response() for q -> infinity, faster than
/// exp(-q). The coating is bonded, and its surface carries no shear stress. With mu = G_coating/G_body, e = exp(-2q):
///   kappa = (mu - 1)/(mu + 3 - 4 nu_c),   lambda = 1 - 4 (1 - nu_c)/(1 + mu (3 - 4 nu_b)),
///   (1 + R) (E_c/(1 - nu_c^2)) / (E_b/(1 - nu_b^2)) = [1 + 4 q kappa e - lambda kappa e^2] / [(1 - lambda e)(1 - kappa
///   e) - 4 kappa q^2 e].
/// source: O'Sullivan and King, J. Tribol. 110 (1988) 235; Nogi and Kato, J. Tribol. 119 (1997) 493.
double response(const Coating& coating, double q);
/// R(infinity): a half-space of the coating's material instead of the body's.
double local_response(const Coating& coating);

/// What a coating adds to the kernel of the uncoated bodies, 1/r for points and -ln|x| for lines: the transform of
/// share R(k t) times that of the kernel. Far away it falls as r^-3, or x^-2. Near the load it is share R(infinity)
/// times the kernel plus a smooth function, which this class evaluates:
///   points: share (1/t) integral of [R(q) - R(infinity)] J0(q r/t) dq,
///   lines:  share [integral of [R(q) - R(infinity) (1 - exp(-q))] cos(q x/t) dq/q + R(infinity) ln(x^2 + t^2)/2],
///           less its value at x = 1, so that K vanishes there as without coatings. H00 absorbs this constant.
///
/// The integrals, by Gauss quadrature over half waves, are tabulated in asinh(r/t) and interpolated by polynomials of
/// degree 7. limits: moduli that differ by a factor of 1000 at most. error: below 1e-10 of share R(infinity) times 1/r,
/// or times 1 for lines (tests/unit/kernel/test_coating.cpp).
class SmoothPart {
 public:
  SmoothPart(const Coating& coating, bool plane);

  /// in: r >= 0.
  double operator()(double r) const;
  /// share R(infinity), the factor of the kernel.
  double local() const { return local_; }
  double thickness() const { return thickness_; }

 private:
  bool plane_;
  double thickness_, local_;
  double at_one_ = 0.0;        ///< lines: the value that is subtracted
  std::vector<double> table_;  ///< at asinh(r/t) = (n - before) table_step
};

}  // namespace ehl::kernel
