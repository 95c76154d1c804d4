#pragma once
// The friction of a lubricated contact, from its pressure and its film.
//
// The stress in the film is tau(z) = tau_m + (z - h/2) dp/dx, surface 2 at z = 0 with speed u2, surface 1 at z = h with
// u1; tau_m = eta_y (u1 - u2)/h, eta_y the viscosity across sliding (rheology/shear.hpp). What the film does to the
// surfaces along +x:
//   surface 1   -(tau_m + (h/2) dp/dx),   surface 2   tau_m - (h/2) dp/dx.
// The part of tau_m is sliding friction, that of dp/dx rolling friction. Across the entrainment nothing slides, and the
// film pulls at both surfaces with -(h/2) dp/dy along +y.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"

namespace ehl::friction {

/// What fills the gap where P = 0 behind a pressurised film.
enum class Cavitated {
  none,      ///< nothing that could be sheared
  striated,  ///< streamers: H_r/H of the width, H_r the film where the line's pressure ended
  full,      ///< oil
};

/// Largest limiting stress over pressure that is known of lubricants. source: REFERENCE, 0.03 to 0.12.
inline constexpr double largest_limit = 0.12;

struct Parameters {
  double stress = 0.0;  ///< eta_0 (u1 - u2) R/(a^2 p_h): tau_m/p_h where H = 1 and eta_bar = 1; signed
  double slope = 0.0;   ///< a/R
  Cavitated cavitated = Cavitated::striated;
  double limit = std::numeric_limits<double>::infinity();  ///< Lambda
  bool keep_tau1 = false, keep_tau2 = false;
  bool aslant = false;  ///< not symmetric in Y: there is a force along it
  /// What stands before it is counted apart: the outer half of an inlet that oil fills. None: NaN.
  double outer_X = std::numeric_limits<double>::quiet_NaN();
};

/// What is upstream of a line contact's domain, where its pressure is that of the far field.
struct Upstream {
  double lambda = 0.0;
  double flow = 0.0;  ///< that goes through, rho_bar H where dP/dX = 0
};

/// A solved contact on its whole domain.
struct Film {
  const core::Grid& grid;
  const core::Field& P;
  const core::Field& H;
  const rheology::ViscosityLaw& viscosity;
  const std::optional<rheology::ShearThinning>& thinning;
  const core::Field* I0 = nullptr;        ///< mean fluidity of a warm film over that of the oil; none: 1
  const core::Field* less_tau = nullptr;  ///< of the sliding stress, where the pressure's own flow thins; none: 1
  std::optional<Upstream> upstream{};     ///< absent: no pressure there
};

/// Forces are over the load, the integral of P: friction coefficients.
struct Friction {
  Parameters parameters;
  bool thinned = false;                                    ///< by a shear law
  double sliding = 0.0;                                    ///< integral of tau_m; > 0 where surface 1 is the faster one
  double rolling = 0.0;                                    ///< integral of (h/2) dp/dx; it holds back both surfaces
  double on_1 = 0.0;                                       ///< force on surface 1 along +x: -(sliding + rolling)
  double on_2 = 0.0;                                       ///< on surface 2: sliding - rolling
  double side = std::numeric_limits<double>::quiet_NaN();  ///< force on each surface along +y; NaN where not aslant
  double cavitated = 0.0;                                  ///< part of `sliding` from where P = 0
  double upstream = 0.0;                                   ///< part of `rolling` from before the domain
  double outer = 0.0;                                      ///< part of `rolling` from before outer_X
  double largest_stress = 0.0;                             ///< of |tau_m| where P > 0, in p_h
  double limited_share = 0.0;                              ///< share of the load that stands where the limit acts
  double unlikely_share = 0.0;                             ///< share of the load where |tau_m| > largest_limit P
  core::Field tau1{}, tau2{};                              ///< in p_h; empty where they are not kept
  double seconds = 0.0;
};

/// The friction of a film. in: P and H on all of a domain; H > 0 where something is sheared.
/// The integral of tau_m by the trapezoidal rule, those of H dP/dX and H dP/dY as sum of H (mean of the two nodes)
/// times the differences of P; upstream of a line's domain H dP/dX = lambda (H - flow)/H^2, which falls as 1/X^2:
/// beyond X_a = -4.5 that is 6 to 18 % of the rolling friction. order: 2, with P and H of order 2; with Cavitated::none
/// 1 in the part beside the edge. Round a point H dP/dX falls as 1/r^2, so that its integral grows with the logarithm
/// of the domain: the outer half of the inlet tells what one of twice the length would add. cost: one viscosity per
/// node.
Friction friction_of(const Film& film, const Parameters& parameters);

/// What is wrong with the numbers, in words: a Newtonian oil that would carry what no lubricant can.
std::vector<std::string> warnings(const Friction& friction);

}  // namespace ehl::friction
