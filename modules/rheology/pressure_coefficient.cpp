#include "rheology/pressure_coefficient.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

namespace ehl::rheology {
namespace {

constexpr int most_panels = 20000;  // a guard: ln eta_bar rises by up to one in a panel, and at 40 the rest is nothing

// A pressure at which ln eta_bar is about one; infinite where there is none.
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
    // What is left is about eta_bar^-1 over its logarithmic slope.
    if (std::exp(-log_here) * width < 1e-17 * rise * sum) break;
    width *= 1.5;
  }
  return sum;
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

}  // namespace ehl::rheology
