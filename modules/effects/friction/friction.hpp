#pragma once
// Friction of a lubricated contact, from its pressure and its film.
//
// Stress in the film: tau(z) = tau_m + (z - h/2) dp/dx, with surface 2 at z = 0, speed u2, and surface 1 at z = h,
// speed u1; tau_m = eta_y (u1 - u2)/h, eta_y the viscosity in the direction of sliding (rheology/shear.hpp). Forces
// along +x:
//   surface 1   -(tau_m + (h/2) dp/dx),   surface 2   tau_m - (h/2) dp/dx.
// The part with tau_m is sliding friction, that with dp/dx rolling friction. There is no sliding along y, where the
// force on both surfaces is -(h/2) dp/dy.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "core/warning.hpp"
#include "rheology/laws.hpp"
#include "rheology/shear.hpp"

namespace ehl::friction {

/// What is sheared where P = 0 behind a pressurised film.
enum class Cavitated {
  none,      ///< nothing
  striated,  ///< oil streamers that fill H_r/H of the width, H_r the film where the pressure of the line ended
  full,      ///< a gap full of oil
};

/// Largest ratio of limiting shear stress to pressure known for lubricants. source: REFERENCE, 0.03 to 0.12.
inline constexpr double largest_limit = 0.12;

/// Parameters of the friction; stresses in p_h, lengths in a.
struct Parameters {
  double stress = 0.0;  ///< eta_0 (u1 - u2) R/(a^2 p_h): tau_m/p_h where H = 1 and eta_bar = 1; signed
  double slope = 0.0;   ///< a/R
  /// k of the scene's shear thinning at the time of `stress`; NaN: that of the scene.
  double thinning_k = core::unknown;
  Cavitated cavitated = Cavitated::striated;
  double limit = std::numeric_limits<double>::infinity();  ///< Lambda: limiting shear stress over pressure
  double boundary = 0.0;                                   ///< friction coefficient where the surfaces touch
  bool keep_tau1 = false, keep_tau2 = false;
  bool oblique = false;  ///< not symmetric in Y, so that a side force exists
  /// Rolling friction of X < outer_X is reported separately: the outer half of a flooded inlet. NaN: not reported.
  double outer_X = core::unknown;
  /// Oil fills the gap up to the undeformed gap at X = -meniscus; infinite: everywhere.
  double meniscus = std::numeric_limits<double>::infinity();
};

/// Film outside the domain (beyond.hpp).
struct Outside;

/// A solved contact on its whole domain.
struct Film {
  const core::Grid& grid;
  const core::Field& P;
  const core::Field& H;
  const rheology::ViscosityLaw& viscosity;
  const std::optional<rheology::ShearThinning>& thinning;
  const core::Field* I0 = nullptr;        ///< mean fluidity over that at the supply temperature; null: 1
  const core::Field* less_tau = nullptr;  ///< factor on tau_m from shear thinning by the pressure flow; null: 1
  /// Load of the contact inside and outside the domain, in p_h a^2 (line contact: p_h a). NaN: the integral of P on the
  /// domain.
  double load = core::unknown;
  core::QuadraticForm gap{0.5, 0.0, 0.5};  ///< of the undeformed bodies; gives the contour of the meniscus
  double lambda = 0.0;                     ///< of a line contact with `outside`
  const Outside* outside = nullptr;        ///< null: no oil there
  const core::Field* P_c = nullptr;        ///< pressure of touching surfaces; P is that of the oil alone; null: 0
  bool starved = false;                    ///< upstream of the film the surfaces carry separate layers
};

/// Forces over the load of the contact: friction coefficients.
struct Friction {
  Parameters parameters;
  bool thinned = false;         ///< by a shear-thinning law
  bool line = false;            ///< forces per length
  bool counts_outside = false;  ///< the parts outside the domain are known
  double sliding = 0.0;         ///< integral of tau_m; > 0 if surface 1 is the faster one
  double rolling = 0.0;         ///< integral of (h/2) dp/dx; opposes the motion of both surfaces
  double on_1 = 0.0;            ///< force on surface 1 along +x: -(sliding + rolling)
  double on_2 = 0.0;            ///< on surface 2: sliding - rolling
  double side = core::unknown;  ///< force on each surface along +y; NaN if the contact is symmetric in Y
  double boundary = 0.0;        ///< part of `sliding` from touching surfaces
  double cavitated = 0.0;       ///< part of `sliding` where P = 0
  double beyond = 0.0;          ///< part of `sliding` outside the domain
  double rolling_beyond = 0.0;  ///< part of `rolling` outside the domain
  double outer = 0.0;           ///< part of `rolling` at X < outer_X
  double largest_stress = 0.0;  ///< largest |tau_m| where P > 0, in p_h
  double limited_share = 0.0;   ///< share of the load where the limiting stress acts, on the domain
  double unlikely_share = 0.0;  ///< share of the load where |tau_m| > largest_limit P, on the domain
  /// Estimated relative errors of `sliding` and `rolling`, from the solutions on coarser grids; NaN if unknown.
  double error_sliding = core::unknown;
  double error_rolling = core::unknown;
  core::Field tau1{}, tau2{};  ///< surface stresses in p_h; empty unless kept
  double seconds = 0.0;
};

/// Friction of a film. in: P and H on the whole domain; H > 0 where the film is sheared. The trapezoidal rule
/// integrates tau_m; the integrals of H dP/dX and H dP/dY are sums of H (mean of two nodes) times the difference of P.
/// beyond() adds the part outside the domain, up to the meniscus. For line contacts both parts converge there, because
/// H dP/dX decays as 1/X^2. For point contacts the integrands decay as 1/r^2, so both integrals grow with the logarithm
/// of the meniscus and depend on it. Without a far field, `outer` (the outer half of the inlet) shows about what an
/// inlet of twice the length would add to the rolling friction.
/// order: 2 if P and H have order 2; with Cavitated::none, 1 for the cells at the film edge. cost: one viscosity per
/// node.
Friction friction_of(const Film& film, const Parameters& parameters);

/// True if the stress of the oil, before any limit, exceeds what lubricants can carry on a significant part of the
/// load.
bool exceeds_any_oil(const Friction& friction);
/// True if it does, and no [friction] limit reduces it.
bool unlikely(const Friction& friction);
/// Warnings in words: a Newtonian oil with stresses that no lubricant can carry.
core::Warnings warnings(const Friction& friction);

}  // namespace ehl::friction
