#pragma once
// Gaussian heights with a band of wave numbers on a cell.
#include <cmath>
#include <random>
#include <vector>

#include "asperities/cosine_transform.hpp"

namespace support {

/// Heights with root mean square Sq, whose power falls with q^-exponent between the wavelengths `longest` and
/// `shortest` [m]; stretched by `gamma` along x.
inline std::vector<double> random_heights(const ehl::asperities::Cell& cell, double Sq, double longest, double shortest,
                                          double exponent, double gamma, unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&] { return (static_cast<double>(generator()) + 0.5) / 4294967296.0; };
  std::vector<double> spectrum, z;
  for (int k = 0; k < cell.nx; ++k)
    for (int l = 0; l < cell.ny; ++l) {
      const double normal = std::sqrt(-2.0 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
      const double q = std::hypot(cell.wave_number_x(k) * std::sqrt(gamma), cell.wave_number_y(l) / std::sqrt(gamma));
      const bool inside = q >= 6.283185307179586 / longest && q <= 6.283185307179586 / shortest;
      spectrum.push_back(inside ? normal * std::pow(q, -0.5 * exponent) : 0.0);
    }
  ehl::asperities::CosineTransform(cell, 1).inverse(spectrum, z);
  double sum = 0.0;
  for (const double height : z) sum += height * height;
  for (double& height : z) height *= Sq / std::sqrt(sum / static_cast<double>(z.size()));
  return z;
}

}  // namespace support
