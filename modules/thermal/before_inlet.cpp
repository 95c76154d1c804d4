#include "thermal/before_inlet.hpp"

#include <cmath>
#include <numbers>

namespace ehl::thermal {
namespace {

// (1/pi) exp(z) K0(z), z = Pe s/2: temperature at the distance s downstream of a line source.
double of_line_source(double Pe, double s) {
  constexpr double far = 50.0;  // beyond this the asymptote is accurate enough
  const double z = 0.5 * Pe * s;
  if (z > far) return (1.0 - 1.0 / (8.0 * z)) / std::sqrt(std::numbers::pi * Pe * s);
  return std::exp(z) * std::cyl_bessel_k(0.0, z) / std::numbers::pi;
}

}  // namespace

std::vector<double> before_inlet(const core::Patch& line, const std::vector<double>& marched, double Pe,
                                 double factor) {
  const double h = line.hx(), length = -line.domain.X_a;
  const auto share = [length](double s) {
    const double nearer = length / (length + s);
    return nearer * nearer * nearer;
  };
  const auto nodes = static_cast<std::size_t>(line.nodes_x());
  std::vector<double> shares(nodes), E(nodes);
  for (std::size_t k = 1; k < nodes; ++k) shares[k] = share(static_cast<double>(k) * h);
  constexpr double longer = 1.1;    // growth of the panels of the midpoint rule for the rest
  constexpr double far_away = 1e3;  // in lengths; the integral is cut off here
  for (std::size_t i = 0; i < nodes; ++i) {
    for (std::size_t k = 1; i + k < nodes; ++k) E[i] += marched[i + k] * shares[k];
    const double place = static_cast<double>(i) * h;
    double begin = (static_cast<double>(nodes - i) - 0.5) * h;
    while (begin < far_away * length) {
      const double end = longer * begin + h, s = 0.5 * (begin + end);
      E[i] += factor * (end - begin) * share(s) * of_line_source(Pe, place + s);
      begin = end;
    }
  }
  return E;
}

}  // namespace ehl::thermal
