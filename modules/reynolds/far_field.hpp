#pragma once
// The pressure far from the contact, where the bodies are as good as rigid, in closed form.
#include <vector>

#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "reynolds/reduced_pressure.hpp"
#include "rheology/laws.hpp"

namespace ehl::reynolds {

/// What a far field follows from.
struct FarFieldOf {
  core::QuadraticForm gap;  ///< of the undeformed bodies, g(phi) r^2
  double lambda = 1.0;      ///< eq. (5)
  /// Of the load at r = 1: K*P -> deformation/r far away, 4/(3 pi) of a circle; of a line -deformation ln|X|, 1/2.
  double deformation = 0.0;
  rheology::ViscosityLaw viscosity;  ///< the oil's; its compression is left out
  core::Grid domain{};               ///< holds the origin; for load_outside
};

/// What of it changes while a contact is solved, or in time.
struct FarState {
  double H00 = 0.0;
  double speed = 1.0;      ///< U >= 0
  double approach = 0.0;   ///< -dH00/dT
  double load = 1.0;       ///< that deforms the bodies, over the one of FarFieldOf::deformation
  double load_rate = 0.0;  ///< its rate of change
  double flow = 0.0;       ///< of oil through a line contact, rho_bar H where dP/dX = 0
};

/// What a point outside has of it, q H^2 per unit of U and of -dH00/dT.
struct FarPoint {
  double wedge = 0.0;
  double squeeze = 0.0;     ///< nothing where the wedge alone ruptures
  double unruptured = 0.0;  ///< of the wedge, were there no rupture: less than the true one
  double yielding = 0.0;    ///< of the film there while the load grows, as a part of an approach
  double X = 0.0;           ///< its place, of a line contact alone
};

/// With H = g(phi) r^2, g of any ellipse and angle, div(H^3 grad q) = lambda dH/dX (q the reduced pressure, dq =
/// dP/eta_bar) and rupture, q >= 0, have the solution q = r^-3 f(phi): (g^3 f')' - 9 g^3 f = lambda s, s = dH/dX at
/// r = 1, with f >= 0 complementary. For a circle f = lambda (0.8 cos phi + 0.00173 cosh 3 phi), phi from the upstream
/// axis, up to 108.44 degrees. With the film that there is, H = H00 + g r^2 + deformation/r, q = f g^2 r/H^2: where
/// nothing ruptures that solves the equation for any H00 without deformation. What the contact itself does is smaller
/// by three powers of r. (The deformation's own next term, as r^-6, is of no use: the contact answers by one as r^-6.16
/// of the opposite sign.)
/// In time, right-hand side lambda (U dH/dX - V), V = -dH00/dT: to first order in V/(U r) q = r^-3 U f + r^-4 V f_1,
/// (g^3 f_1')' - 8 g^3 f_1 = -lambda between the lines of rupture, f_1 = 0 on them. Without rupture both are
/// elementary, q = (-U k.x + V c)/H^2 with (A + 2 tr(A)) k = lambda A e_X, c = lambda/(4 tr(A)) for H = x A x: a
/// solution for any ratio of the two that is below the true one, and what q goes over to where V > 0 is large. While
/// the load grows the film far away falls by less than H00: V is less by a term in 1/r. limits: H > 0 on the boundary
/// and outside.
///
/// A line contact, gap.YY = 0, has one flow, which what the contact does does not leave further away: upstream dq/dX =
/// lambda U (H - flow)/H^3 is integrated from X = -infinity, with H = H00 + g X^2 - deformation ln|X|; downstream the
/// film is ruptured. Steady alone.
class FarField {
 public:
  FarField() = default;
  /// errors: core::SolverError where the rupture of the angular solution is not found.
  explicit FarField(const FarFieldOf& of);

  /// Of a point, once; then P there from the film there. Zero where it is ruptured; NaN where the viscosity rises so
  /// fast that no pressure has this reduced one: far too near. limits: not the origin.
  FarPoint at(double X, double Y) const;
  double P(const FarPoint& point, double H, const FarState& state) const;
  /// Steady.
  double P(double X, double Y, double H) const { return P(at(X, Y), H, {}); }
  /// Integral of P over all that lies outside the domain, in units of p_h a^2. cost: some 700 evaluations of P, half as
  /// many where Y is even.
  double load_outside(const FarState& state) const;
  /// Angle of the line behind which the film is ruptured, from the X axis upstream, on the side of positive Y.
  double rupture_angle() const;

 private:
  struct Station {  ///< of the quadrature outside
    FarPoint point;
    double gap, deformation, weight;
  };
  void make_stations(const core::Grid& domain);
  bool line() const { return of_.gap.YY == 0.0; }
  double P_of_line(double X, double H, const FarState& state) const;
  double load_outside_of_line(const FarState& state) const;
  FarPoint toward(double cosine, double sine) const;  // at r = 1

  FarFieldOf of_{};
  double k_X_ = 0.0, k_Y_ = 0.0, c_ = 0.0;
  std::vector<double> wedge_, squeeze_;  ///< f g^2 and f_1 g^2 from the X axis on, against the clock, once around
  ReducedPressure pressure_;
  std::vector<Station> stations_;
};

}  // namespace ehl::reynolds
