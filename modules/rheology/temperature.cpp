#include "rheology/temperature.hpp"

#include <cmath>

namespace ehl::rheology {
namespace {

// Term that ASTM D341 adds to nu + 0.7; negligible above 2 mm^2/s.
double low_viscosity_term(double nu) { return std::exp(-1.47 - 1.84 * nu - 0.51 * nu * nu); }

double log_log_Z(double nu) { return std::log10(std::log10(nu + 0.7 + low_viscosity_term(nu))); }

}  // namespace

Walther make_walther(double kv40, double kv100) {
  const double log_T40 = std::log10(40.0 + zero_celsius), log_T100 = std::log10(100.0 + zero_celsius);
  const double at_40 = log_log_Z(kv40);
  const double B = (at_40 - log_log_Z(kv100)) / (log_T100 - log_T40);
  return {at_40 + B * log_T40, B};
}

double kinematic_viscosity(const Walther& law, double T) {
  const double Z = std::pow(10.0, std::pow(10.0, law.A - law.B * std::log10(T + zero_celsius)));
  // The standard's polynomial nu(Z) is only approximate, so the equation itself is iterated. Its contraction factor is
  // 0.3 at 0.21 mm^2/s and falls quickly with nu.
  double nu = Z - 0.7;
  constexpr int enough = 40;  // 0.3^40 = 1e-21
  for (int k = 0; k < enough; ++k) nu = Z - 0.7 - low_viscosity_term(nu);
  return nu;
}

double oil_density(double density15, double T) {
  const double expansion = 0.6278 / density15 * (T - 15.0);
  return density15 * std::exp(-expansion * (1.0 + 0.8 * expansion));
}

}  // namespace ehl::rheology
