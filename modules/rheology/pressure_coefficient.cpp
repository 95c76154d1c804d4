#include "rheology/pressure_coefficient.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/constants.hpp"

namespace ehl::rheology {
namespace {

// Safeguard: ln eta_bar rises by up to one per panel, and beyond 40 the rest of the integral is negligible.
constexpr int most_panels = 20000;

// A pressure at which ln eta_bar is about one; infinite if there is none.
double pressure_of_one(const ViscosityLaw& law) {
  double P = 1.0;
  for (int k = 0; k < 200 && log_viscosity_at(law, P) > 1.0; ++k) P *= 0.5;
  for (int k = 0; k < 200; ++k, P *= 2.0)
    if (log_viscosity_at(law, P) >= 0.5) return P;
  return std::numeric_limits<double>::infinity();
}

using GaussLegendre = boost::math::quadrature::gauss<double, 10>;

// int_0^end 1/eta_bar dP.
double integral_of_fluidity(const ViscosityLaw& law, double scale, double end) {
  double sum = 0.0, P = 0.0, width = scale / 16.0, log_here = 0.0;
  for (int panel = 0; panel < most_panels && P < end; ++panel) {
    width = std::min(width, end - P);
    double rise = log_viscosity_at(law, P + width) - log_here;
    while (rise > 1.0 && P + 0.5 * width > P) {
      width *= 0.5;
      rise = log_viscosity_at(law, P + width) - log_here;
    }
    sum += GaussLegendre::integrate([&](double p) { return std::exp(-log_viscosity_at(law, p)); }, P, P + width);
    P += width;
    log_here += rise;
    // The rest of the integral is about 1/eta_bar over the logarithmic slope.
    if (std::exp(-log_here) * width < 1e-17 * rise * sum) break;
    width *= 1.5;
  }
  return sum;
}

// Root of an increasing function, to rounding; NaN if it has none between the bounds.
template <class Function>
double root(Function f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (!(at_low <= 0.0 && at_high >= 0.0)) return core::unknown;
  std::uintmax_t steps = 200;  // safeguard; about 10 are needed
  const auto found = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 4),
      steps);
  return 0.5 * (found.first + found.second);
}

}  // namespace

PressureCoefficients pressure_coefficients(const ViscosityLaw& law) {
  const double scale = pressure_of_one(law);
  if (!std::isfinite(scale)) return {};
  PressureCoefficients found;
  found.alpha_star = 1.0 / integral_of_fluidity(law, scale, std::numeric_limits<double>::infinity());
  found.alpha_film = -std::expm1(-3.0) / integral_of_fluidity(law, scale, 3.0 / found.alpha_star);
  return found;
}

double roelands_z_of(double alpha_star, double p0, double eta0) {
  constexpr double pascal = 1.0;
  const double log_ratio = roelands_log_ratio(eta0);
  if (!(log_ratio > 0.0)) return core::unknown;
  const auto miss = [&](double z) {
    return pressure_coefficients(make_roelands(z * log_ratio / p0, p0, z, pascal)).alpha_star / alpha_star - 1.0;
  };
  return root(miss, least_z, most_z);
}

double roelands_alpha_of(double alpha_star, double p0, double z) {
  constexpr double pascal = 1.0;
  const auto miss = [&](double alpha) {
    return pressure_coefficients(make_roelands(alpha, p0, z, pascal)).alpha_star / alpha_star - 1.0;
  };
  // [(1 + p/p0)^z - 1]/z exceeds ln(1 + p/p0), for which alpha* = alpha - 1/p0. The lower bound is for z > 1.
  return root(miss, 1e-4 * alpha_star, alpha_star + 1.0 / p0);
}

}  // namespace ehl::rheology
