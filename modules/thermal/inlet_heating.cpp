#include "thermal/inlet_heating.hpp"

#include <algorithm>
#include <cmath>

namespace ehl::thermal {

double wilson_sheu(const InletGroups& groups) {
  const double Z = 0.5 * std::abs(groups.srr);
  return 1.0 / (1.0 + 0.241 * (1.0 + 14.8 * std::pow(Z, 0.83)) * std::pow(groups.L, 0.64));
}

double murch_wilson(const InletGroups& groups) { return 1.0 / (1.0 + 0.254 * std::pow(groups.L, 0.62)); }

double gupta(const InletGroups& groups) {
  const double above = 1.0 - 13.2 * groups.p_h_over_E * std::pow(groups.L, 0.42);
  const double slides = 1.0 + 2.23 * std::pow(std::abs(groups.srr), 0.83);
  return std::max(0.0, above) / (1.0 + 0.213 * slides * std::pow(groups.L, 0.64));
}

}  // namespace ehl::thermal
