#pragma once
// The pressure far from the contact, where the bodies are as good as rigid, in closed form.
#include <vector>

#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "rheology/laws.hpp"

namespace ehl::reynolds {

/// What a far field follows from.
struct FarFieldOf {
  core::QuadraticForm gap;           ///< of the undeformed bodies, g(phi) r^2
  double lambda = 1.0;               ///< eq. (5)
  double deformation = 0.0;          ///< of the load at r = 1: K*P -> deformation/r far away, 4/(3 pi) of a circle
  rheology::ViscosityLaw viscosity;  ///< the oil's; its compression is left out
};

/// With H = g(phi) r^2, g of any ellipse and angle, div(H^3 grad q) = lambda dH/dX (q the reduced pressure, dq =
/// dP/eta_bar) and rupture, q >= 0, have the solution q = r^-3 f(phi): (g^3 f')' - 9 g^3 f = lambda s, s = dH/dX at
/// r = 1, with f >= 0 complementary. For a circle f = lambda (0.8 cos phi + 0.00173 cosh 3 phi), phi from the upstream
/// axis, up to 108.44 degrees. With the film that there is, H = H00 + g r^2 + deformation/r, q = f g^2 r/H^2: where
/// nothing ruptures that solves the equation for any H00 without deformation. What the contact itself does is smaller
/// by three powers of r. (The deformation's own next term, as r^-6, is of no use: the contact answers by one as r^-6.16
/// of the opposite sign.)
/// limits: H > 0 on the boundary and outside; steady.
class FarField {
 public:
  FarField() = default;
  /// errors: core::SolverError where the rupture of the angular solution is not found.
  explicit FarField(const FarFieldOf& of);

  /// P at a point outside the contact from the film there. Zero where it is ruptured; NaN where the viscosity rises so
  /// fast that no pressure has this reduced one: far too near.
  double P(double X, double Y, double H) const;
  /// Integral of P over all that lies outside the domain, in units of p_h a^2. limits: the domain holds the origin.
  double load_outside(const core::Grid& domain, double H00) const;
  /// Angle of the line behind which the film is ruptured, from the X axis upstream, on the side of positive Y.
  double rupture_angle() const;

 private:
  double strength(double cosine, double sine) const;  // f g^2 at this direction
  double pressure(double reduced) const;

  FarFieldOf of_{};
  std::vector<double> strength_;  // from the X axis on, against the clock, once around
};

}  // namespace ehl::reynolds
