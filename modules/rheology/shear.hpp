#pragma once
// Shear thinning of the lubricant by sliding, and its effect on the pressure flow.
//
// A law gives the shear rate that a stress tau causes, in the direction of the stress:
//   rate_i = F(tau) tau_i/tau,   Eyring F = (tau_0/eta) sinh(tau/tau_0),
//                                Carreau  tau = eta rate [1 + (eta rate/G)^2]^((n-1)/2).
// Sliding by du shears the film with the stress tau_m, F(tau_m) = du/h, along X. A pressure gradient adds a stress that
// is linear across the film with mean zero. To first order in the gradient the fluidity for it is
//   along sliding   1/eta_x = F'(tau_m),    across   1/eta_y = F(tau_m)/tau_m,
// at every height, so that the flow is -h^3/(12 eta_i) dp/dx_i as in a Newtonian film.
// source: Ehret, Dowson and Taylor 1998; Jacod, Venner and Lubrecht 2001, for Eyring; Carreau by the same steps.
// limits: without sliding there is no thinning; flow_thinning.hpp has the thinning by the pressure flow.
#include <span>
#include <variant>

namespace ehl::rheology {

/// tau = tau_c asinh(eta rate/tau_c), with tau_c = tau_0.
struct Eyring {};
/// tau = eta rate [1 + (eta rate/tau_c)^2]^((n-1)/2), with tau_c = G. 0 < n <= 1; n = 1 is Newtonian.
struct Carreau {
  double n;
};
using ShearLaw = std::variant<Eyring, Carreau>;

/// A law in a film with sliding.
struct ShearThinning {
  ShearLaw law;
  /// eta_0 |u1 - u2| R/(a^2 tau_c) >= 0: stress of the unthinned oil over tau_c at H = 1 and eta_bar = 1. 0: Newtonian
  /// film.
  double k = 0.0;
};

/// Viscosities over the viscosity without shear.
struct Thinned {
  double along;   ///< eta_x/eta
  double across;  ///< eta_y/eta = tau_m/(eta rate)
};
/// in: s = eta rate/tau_c >= 0. limits: 1 as s -> 0, by a series; for large s, Eyring's `across` is ln(2 s)/s.
Thinned thinned(const ShearLaw& law, double s);

/// Limiting shear stress: clamps tau to |tau| <= limit = Lambda p. in: limit >= 0, same unit.
double limited(double tau, double limit);

/// eta_0/eta_x and eta_0/eta_y of a film. in: H, and the fluidity eta_0/eta without shear, of equal length. The values
/// are those of thinned() with s = k/(H fluidity), but finite where the fluidity underflows or the film is zero.
/// limits: k -> 0 gives `fluidity` twice, to rounding. H < 1e-30 counts as 1e-30.
void film_fluidity(const ShearThinning& thinning, std::span<const double> H, std::span<const double> fluidity,
                   std::span<double> along, std::span<double> across);

/// d ln(along)/d ln(fluidity) and d ln(across)/d ln(fluidity) at constant H, between 0 (fully thinned) and 1. The
/// derivatives with respect to ln H at constant fluidity are smaller by 1.
void film_fluidity_slopes(const ShearThinning& thinning, std::span<const double> H, std::span<const double> fluidity,
                          std::span<double> along, std::span<double> across);

/// This sliding under a load that multiplies p_h and a by `factor`. in: factor > 0.
ShearThinning rescaled(const ShearThinning& thinning, double factor);

}  // namespace ehl::rheology
