#include "effects/starvation/formulas.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"

namespace ehl::starvation {

double by_supply(double r, double gamma) { return by_passes(r, gamma, 1); }

double by_passes(double r, double gamma, int passes) {
  return r / std::pow(1.0 + passes * std::pow(r, gamma), 1.0 / gamma);
}

double gamma_of(double r, double factor) {
  constexpr double nothing = 0.01;  // closer to r or 1, gamma is ill-conditioned [bench: starvation_gamma_margin]
  constexpr double least = 0.5, most = 30.0;
  if (!(factor < (1.0 - nothing) * std::fmin(r, 1.0))) return core::unknown;
  double below = least, above = most;  // by_supply() increases with gamma
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (below + above);
    (by_supply(r, middle) < factor ? below : above) = middle;
  }
  return below > least ? below : core::unknown;
}

double flooded_inlet(double Hc_flooded) { return 1.0 + 3.06 * std::pow(Hc_flooded, 0.58); }

double by_meniscus(double m, double Hc_flooded) {
  const double enough = flooded_inlet(Hc_flooded);
  return m >= enough ? 1.0 : m > 1.0 ? std::pow((m - 1.0) / (enough - 1.0), 0.29) : 0.0;
}

double lost_by_pass(const contact::Ellipse& shape, double lambda, const rheology::ViscosityLaw& viscosity,
                    const rheology::DensityLaw& density) {
  if (!contact::circular(shape) && shape.angle != 0.0) return core::unknown;
  // The trapezoidal rule converges fast here, because the integrand is even and smooth about both ends.
  constexpr std::size_t intervals = 400;
  constexpr double step = std::numbers::pi / intervals;
  std::array<double, intervals + 1> P{}, log_eta{}, rho{};
  for (std::size_t k = 0; k <= intervals; ++k) P[k] = std::cos(step * static_cast<double>(k) - 0.5 * std::numbers::pi);
  rheology::log_viscosity(viscosity, P, log_eta);
  rheology::density(density, P, rho);
  double I = 0.0;
  for (std::size_t k = 0; k <= intervals; ++k)
    I += (k == 0 || k == intervals ? 0.5 : 1.0) * step * std::exp(-log_eta[k]) / (rho[k] * rho[k]);
  // dP/dY = -Y/(b^2 sqrt(1 - X^2/a^2)) near y = 0, with the semi-axes 1 and kappa in units of a.
  return 2.0 * I / (lambda * shape.kappa * shape.kappa);
}

}  // namespace ehl::starvation
