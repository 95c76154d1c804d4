#include "effects/subsurface/strip.hpp"

#include <cmath>
#include <vector>

#include "core/constants.hpp"

namespace ehl::subsurface {
namespace {

// Direction from a corner: angle t, sin 2t, cos 2t, and ln r.
struct Direction {
  double t, sine, cosine, ln_r;
};
Direction direction(double u, double z) {
  const double square = u * u + z * z;
  return {std::atan2(z, u), 2.0 * u * z / square, (u * u - z * z) / square, 0.5 * std::log(square)};
}

// Difference between the right and the left corner of a strip from -half_x to half_x.
Direction between(double x, double z, double half_x) {
  const Direction right = direction(x - half_x, z), left = direction(x + half_x, z);
  return {right.t - left.t, right.sine - left.sine, right.cosine - left.cosine, right.ln_r - left.ln_r};
}

Stress plane_strain(double x, double z, double both, double nu) {
  Stress s{};
  s[xx] = x / (2.0 * core::pi);
  s[zz] = z / (2.0 * core::pi);
  s[yy] = nu * (s[xx] + s[zz]);
  s[xz] = both / (2.0 * core::pi);
  return s;
}

}  // namespace

Stress normal_strip(double x, double z, double half_x, double nu) {
  const Direction d = between(x, z, half_x);
  return plane_strain(-(2.0 * d.t + d.sine), -(2.0 * d.t - d.sine), d.cosine, nu);
}

Stress shear_strip(double x, double z, double half_x, double nu) {
  const Direction d = between(x, z, half_x);
  return plane_strain(4.0 * d.ln_r - d.cosine, d.cosine, -(2.0 * d.t + d.sine), nu);
}

StripKernel::StripKernel(const core::Grid& grid, double of_body, double z) : nu(of_body) {
  const double half_x = 0.5 * grid.hx();
  for (int d = -grid.nx; d <= grid.nx; ++d) {
    const double x = d * grid.hx();
    const Stress normal = normal_strip(x, z, half_x, nu), shear = shear_strip(x, z, half_x, nu);
    for (const Component k : {xx, zz, xz}) {
      under[pressed][k].push_back(normal[k]);
      under[sheared][k].push_back(shear[k]);
    }
  }
}

void stress_of_line(const StripKernel& kernel, const core::Grid& grid, const core::Field& P, double friction,
                    StressFields& stress) {
  const int nodes = grid.nodes_x();
  std::vector<double> pressure(static_cast<std::size_t>(nodes));  // from right to left
  for (int m = 0; m < nodes; ++m) pressure[static_cast<std::size_t>(m)] = P(grid.nx - m, 1);
  std::vector<double> below(kernel.under[pressed][xx].size());
  const auto fill = [&](Component k, int i, double value) {
    for (int j = 0; j < grid.nodes_y(); ++j) stress[k](i, j) = value;
  };
  for (const Component k : {xx, zz, xz}) {
    for (std::size_t d = 0; d < below.size(); ++d)
      below[d] = kernel.under[pressed][k][d] + friction * kernel.under[sheared][k][d];
    for (int i = 0; i < nodes; ++i) {
      double sum = 0.0;
#pragma omp simd reduction(+ : sum)
      for (int m = 0; m < nodes; ++m)
        sum += pressure[static_cast<std::size_t>(m)] * below[static_cast<std::size_t>(i + m)];
      fill(k, i, sum);
    }
  }
  for (int i = 0; i < nodes; ++i) {
    fill(yy, i, kernel.nu * (stress[xx](i, 1) + stress[zz](i, 1)));
    fill(xy, i, 0.0);
    fill(yz, i, 0.0);
  }
}

}  // namespace ehl::subsurface
