#include "machines/impact.hpp"

#include <cmath>

namespace ehl::machines {

DryImpact dry_impact(double mass, double velocity, double compliance) {
  // 2 integral of (1 - x^(5/2))^(-1/2) = (4/5) B(2/5, 1/2)
  static const double of_contact = 0.8 * std::tgamma(0.4) * std::tgamma(0.5) / std::tgamma(0.9);
  const double approach = std::pow(1.25 * mass * velocity * velocity * std::pow(compliance, 1.5), 0.4);
  return {std::pow(approach / compliance, 1.5), approach, of_contact * approach / velocity};
}

}  // namespace ehl::machines
