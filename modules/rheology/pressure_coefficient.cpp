#include "rheology/pressure_coefficient.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ehl::rheology {
namespace {

constexpr int most_panels = 20000;

double log_viscosity_at(const ViscosityLaw& law, double P) {
  std::array<double, 1> out{};
  log_viscosity(law, std::array{P}, out);
  return out[0];
}

// A pressure at which ln eta_bar is about one; infinite where there is none.
double pressure_of_one(const ViscosityLaw& law) {
  double P = 1.0;
  for (int k = 0; k < 200 && log_viscosity_at(law, P) > 1.0; ++k) P *= 0.5;
  for (int k = 0; k < 200; ++k, P *= 2.0)
    if (log_viscosity_at(law, P) >= 0.5) return P;
  return std::numeric_limits<double>::infinity();
}

// int_a^b 1/eta_bar dP by Gauss and Legendre's rule of ten points. source: Abramowitz and Stegun, Table 25.4.
double panel_of_fluidity(const ViscosityLaw& law, double a, double b) {
  constexpr std::array<double, 5> node{0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                                       0.9739065285171717};
  constexpr std::array<double, 5> weight{0.2955242247147529, 0.2692667193099964, 0.2190863625159820, 0.1494513491505806,
                                         0.0666713443086881};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  std::array<double, 10> P{}, value{};
  for (std::size_t k = 0; k < 5; ++k) {
    P[2 * k] = middle - half * node[k];
    P[2 * k + 1] = middle + half * node[k];
  }
  fluidity(law, P, value);
  double sum = 0.0;
  for (std::size_t k = 0; k < 5; ++k) sum += weight[k] * (value[2 * k] + value[2 * k + 1]);
  return half * sum;
}

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
    sum += panel_of_fluidity(law, P, P + width);
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
