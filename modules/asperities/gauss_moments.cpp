#include "asperities/gauss_moments.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::asperities {

// With u = s - l and the factor exp(-l^2/2) taken out, the integral of a large l does not underflow. For l < 0 the
// maximum lies at u = -l, and the range is divided there.
double gauss_moment(double n, double l) {
  const double norm = 1.0 / std::sqrt(2.0 * core::pi);
  boost::math::quadrature::exp_sinh<double> to_infinity;
  if (l >= 0.0) {
    // The scale of u is 1/l for large l: with it the quadrature sees the same function for every l.
    const double scale = 1.0 / (1.0 + l);
    const auto f = [&](double v) {
      const double u = scale * v;
      return std::pow(v, n) * std::exp(-u * (0.5 * u + l));
    };
    return norm * std::exp(-0.5 * l * l) * std::pow(scale, n + 1.0) * to_infinity.integrate(f, 1e-13);
  }
  boost::math::quadrature::tanh_sinh<double> between;
  const auto f = [&](double u) { return std::pow(u, n) * std::exp(-0.5 * (u + l) * (u + l)); };
  const auto beyond = [&](double v) { return std::pow(v - l, n) * std::exp(-0.5 * v * v); };
  return norm * (between.integrate(f, 0.0, -l, 1e-13) + to_infinity.integrate(beyond, 1e-13));
}

}  // namespace ehl::asperities
