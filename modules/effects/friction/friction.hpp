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
#include "core/quadratic_form.hpp"
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
  /// Oil fills the gap as far as the undeformed gap is no wider than at X = -meniscus; infinite: everywhere.
  double meniscus = std::numeric_limits<double>::infinity();
};

/// What is outside of the domain (beyond.hpp).
struct Outside;

/// A solved contact on its whole domain.
struct Film {
  const core::Grid& grid;
  const core::Field& P;
  const core::Field& H;
  const rheology::ViscosityLaw& viscosity;
  const std::optional<rheology::ShearThinning>& thinning;
  const core::Field* I0 = nullptr;        ///< mean fluidity of a warm film over that of the oil; none: 1
  const core::Field* less_tau = nullptr;  ///< of the sliding stress, where the pressure's own flow thins; none: 1
  /// Load of the contact in p_h a^2 (of a line p_h a), what the bodies are pressed together with: inside and outside of
  /// the domain. NaN: the integral of P on the domain.
  double load = std::numeric_limits<double>::quiet_NaN();
  core::QuadraticForm gap{0.5, 0.0, 0.5};  ///< of the undeformed bodies; to find where the oil ends
  double lambda = 0.0;                     ///< of a line with something outside
  const Outside* outside = nullptr;        ///< none: no oil there
  bool starved = false;                    ///< ahead of the film the surfaces carry layers that do not touch
};

/// Forces are over the load of the contact: friction coefficients.
struct Friction {
  Parameters parameters;
  bool thinned = false;                                    ///< by a shear law
  bool line = false;                                       ///< forces per length
  bool counts_outside = false;                             ///< something is known of what is outside of the domain
  double sliding = 0.0;                                    ///< integral of tau_m; > 0 where surface 1 is the faster one
  double rolling = 0.0;                                    ///< integral of (h/2) dp/dx; it holds back both surfaces
  double on_1 = 0.0;                                       ///< force on surface 1 along +x: -(sliding + rolling)
  double on_2 = 0.0;                                       ///< on surface 2: sliding - rolling
  double side = std::numeric_limits<double>::quiet_NaN();  ///< force on each surface along +y; NaN where not aslant
  double cavitated = 0.0;                                  ///< part of `sliding` from where P = 0
  double beyond = 0.0;                                     ///< part of `sliding` from outside of the domain
  double rolling_beyond = 0.0;                             ///< part of `rolling` from outside of the domain
  double outer = 0.0;                                      ///< part of `rolling` from before outer_X
  double largest_stress = 0.0;                             ///< of |tau_m| where P > 0, in p_h
  double limited_share = 0.0;   ///< share of the load that stands where the limit acts, on the domain
  double unlikely_share = 0.0;  ///< share of the load where |tau_m| > largest_limit P, on the domain
  core::Field tau1{}, tau2{};   ///< in p_h; empty where they are not kept
  double seconds = 0.0;
};

/// The friction of a film. in: P and H on all of a domain; H > 0 where something is sheared.
/// The integral of tau_m by the trapezoidal rule, those of H dP/dX and H dP/dY as sum of H (mean of the two nodes)
/// times the differences of P; what lies outside of the domain, up to the meniscus, by beyond(). Of a line both parts
/// converge there, as H dP/dX falls as 1/X^2. Round a point they fall as 1/r^2, so that both integrals grow with the
/// logarithm of the meniscus, and belong to it. Where nothing is known of the outside, the outer half of the inlet
/// states what one of twice the length would add to the rolling friction. order: 2, with P and H of order 2; with
/// Cavitated::none 1 in the part beside the edge. cost: one viscosity per node.
Friction friction_of(const Film& film, const Parameters& parameters);

/// True where the oil would carry what no lubricant can, on a part of the load that counts.
bool unlikely(const Friction& friction);
/// What is wrong with the numbers, in words: a Newtonian oil that would carry what no lubricant can.
std::vector<std::string> warnings(const Friction& friction);

}  // namespace ehl::friction
