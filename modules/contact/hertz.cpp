#include "contact/hertz.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace ehl::contact {

double reduced_modulus(const Elastic& first, const Elastic& second) {
  return 2.0 / ((1.0 - first.nu * first.nu) / first.E + (1.0 - second.nu * second.nu) / second.E);
}

Hertz hertz(double load, double radius, double E_prime) {
  const double a = std::cbrt(1.5 * load * radius / E_prime);
  const double p_h = 1.5 * load / (core::pi * a * a);
  const double approach = a * a / radius;
  return {a, p_h, approach, approach};
}

}  // namespace ehl::contact
