#include "contact/coatings.hpp"

#include <cmath>

#include "contact/hertz.hpp"

namespace ehl::contact {
namespace {

/// Wave number of the pressure of a contact, times its shorter semi-axis. [bench: coating_wave_number]
constexpr double typical_wave = 2.0;

}  // namespace

double equivalent_modulus(const Bodies& bodies, const Ellipse& shape) {
  if (bodies.coatings.empty()) return bodies.E_prime;
  const auto found = [&](double log_E) {
    const double E = std::exp(log_E);
    const double k = typical_wave / (hertz(bodies.load, bodies.radius, E, shape).a * extent(shape).shorter);
    double compliance = 1.0;
    for (const kernel::Coating& coating : bodies.coatings)
      compliance += coating.share * kernel::response(coating, k * coating.thickness);
    return std::log(bodies.E_prime / compliance);
  };
  // Bisection: the moduli of coating and body differ by a factor of 1000 at most.
  double low = std::log(bodies.E_prime * 1e-4), high = std::log(bodies.E_prime * 1e4);
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (found(middle) > middle ? low : high) = middle;
  }
  return std::exp(found(0.5 * (low + high)));
}

}  // namespace ehl::contact
