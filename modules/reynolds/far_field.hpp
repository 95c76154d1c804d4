#pragma once
// The pressure far from the contact, where the bodies are practically rigid, in closed form.
#include <functional>
#include <vector>

#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "reynolds/reduced_pressure.hpp"
#include "rheology/laws.hpp"

namespace ehl::reynolds {

/// Heat upstream decays about as u^2, u = X_a/X, and the integrand of the first node's pressure as u^2 u^2. So ln
/// epsilon at the first node counts upstream with this share: int u^2 u^2 du over int u^2 du.
inline constexpr double share_upstream = 0.6;

/// The constants of a far field.
struct FarFieldOf {
  core::QuadraticForm gap;  ///< of the undeformed bodies, g(phi) r^2
  double lambda = 1.0;      ///< eq. (5)
  /// Coefficient of the deformation far away: K*P -> deformation/r, 4/(3 pi) for a circle; in a line contact K*P ->
  /// -deformation ln|X|, 1/2.
  double deformation = 0.0;
  rheology::ViscosityLaw viscosity;  ///< of the oil; its compressibility is neglected
  core::Grid domain{};               ///< contains the origin; for load_outside()
  /// What coatings on the bodies add to the deformation at the distance r; empty: none.
  std::function<double(double r)> by_coatings{};
};

/// The quantities of a far field that change while a contact is solved, or in time.
struct FarState {
  double H00 = 0.0;
  double speed = 1.0;      ///< U >= 0
  double approach = 0.0;   ///< -dH00/dT
  double load = 1.0;       ///< load that deforms the bodies, over that of FarFieldOf::deformation
  double load_rate = 0.0;  ///< its rate of change
  double flow = 0.0;       ///< flow of oil through a line contact: rho_bar H where dP/dX = 0
};

/// The data of one point outside: q H^2 per unit of U and of -dH00/dT.
struct FarPoint {
  double wedge = 0.0;
  double squeeze = 0.0;     ///< 0 where the wedge alone ruptures the film
  double unruptured = 0.0;  ///< `wedge` without rupture: a lower bound
  double yielding = 0.0;    ///< reduction of the approach per rate of the load
  double X = 0.0;           ///< position, line contacts only
};

/// Point contacts. With H = g(phi) r^2, g of any ellipse and angle, div(H^3 grad q) = lambda dH/dX (q the reduced
/// pressure, dq = dP/eta_bar) with rupture, q >= 0, has the solution q = r^-3 f(phi): (g^3 f')' - 9 g^3 f = lambda s, s
/// = dH/dX at r = 1, with complementary f >= 0. For a circle f = lambda (0.8 cos phi + 0.00173 cosh 3 phi), phi from
/// the upstream axis, up to 108.44 degrees.
///
/// With the actual film, H = H00 + g r^2 + deformation/r, q = f g^2 r/H^2: where nothing ruptures this solves the
/// equation for any H00 without deformation. The contribution of the contact itself is smaller by r^-3. (The next term
/// of the deformation, as r^-6, is not used: the contact adds one as r^-6.16 of the opposite sign.)
///
/// In time, with right-hand side lambda (U dH/dX - V), V = -dH00/dT: to first order in V/(U r) q = r^-3 U f + r^-4 V
/// f_1, (g^3 f_1')' - 8 g^3 f_1 = -lambda between the lines of rupture, f_1 = 0 on them. Without rupture q = (-U k.x +
/// V c)/H^2 with (A + 2 tr(A)) k = lambda A e_X, c = lambda/(4 tr(A)) for H = x A x. This is a lower bound for any
/// ratio of U and V, and the limit of q for large V > 0. While the load grows the film far away falls less than H00: V
/// is smaller by a term in 1/r. limits: H > 0 on the boundary and outside.
///
/// Line contacts, gap.YY = 0, have one flow, and so the contribution of the contact does not decay with the distance.
/// Upstream dq/dX = lambda U (H - flow)/H^3 is integrated from X = -infinity, with H = H00 + g X^2 - deformation ln|X|;
/// downstream the film is ruptured. Steady only.
class FarField {
 public:
  FarField() = default;
  /// errors: core::SolverError if the lines of rupture of the angular solution are not found.
  explicit FarField(const FarFieldOf& of);

  /// at(): the data of a point, computed once. P(): the pressure there for a film H. It is zero where the film is
  /// ruptured, and NaN where the viscosity rises so fast that no pressure has this reduced one, far too close to the
  /// contact. limits: no pressure at the origin.
  FarPoint at(double X, double Y) const;
  double P(const FarPoint& point, double H, const FarState& state) const;
  /// The pressure of the default state, which is steady.
  double P(double X, double Y, double H) const { return P(at(X, Y), H, {}); }
  /// Integral of P over the plane outside the domain, in units of p_h a^2. cost: some 700 evaluations of P, half as
  /// many if the problem is symmetric about Y = 0.
  double load_outside(const FarState& state) const;
  /// FarFieldOf::by_coatings(r), or 0.
  double by_coatings(double r) const { return of_.by_coatings ? of_.by_coatings(r) : 0.0; }
  /// Angle of the line downstream of which the film is ruptured, from the upstream X axis, on the side of positive Y.
  double rupture_angle() const;

 private:
  struct Station {  ///< a point of the quadrature outside the domain
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
  std::vector<double> wedge_, squeeze_;  ///< f g^2 and f_1 g^2, counterclockwise from the downstream X axis
  ReducedPressure pressure_;
  std::vector<Station> stations_;
};

}  // namespace ehl::reynolds
