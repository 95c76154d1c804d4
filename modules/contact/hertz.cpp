#include "contact/hertz.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace ehl::contact {

double reduced_modulus(const Elastic& first, const Elastic& second) {
  return 2.0 / ((1.0 - first.nu * first.nu) / first.E + (1.0 - second.nu * second.nu) / second.E);
}

Hertz hertz(double load, double radius, double E_prime, const Ellipse& shape) {
  if (line(shape)) {
    const double a = std::sqrt(8.0 / core::pi * load * radius / E_prime);
    const double h_scale = a * a / radius;
    return {a, 2.0 * load / (core::pi * a), shape.approach * h_scale, h_scale, shape.kappa * a};
  }
  const double a = shape.a * std::cbrt(1.5 * load * radius / E_prime);
  const double b = shape.kappa * a;
  const double p_h = 1.5 * load / (core::pi * a * b);
  const double h_scale = a * a / radius;
  return {a, p_h, shape.approach * h_scale, h_scale, b};
}

}  // namespace ehl::contact
