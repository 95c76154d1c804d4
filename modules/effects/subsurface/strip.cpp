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

void stress_of_line(const core::Grid& grid, const core::Field& P, const Body& body, double z, StressFields& stress) {
  std::vector<Stress> below;  // a cell, at offsets -nx to nx
  for (int d = -grid.nx; d <= grid.nx; ++d) {
    const double x = d * grid.hx(), half_x = 0.5 * grid.hx();
    Stress& one = below.emplace_back(normal_strip(x, z, half_x, body.nu));
    const Stress shear = shear_strip(x, z, half_x, body.nu);
    for (std::size_t k = 0; k < components; ++k) one[k] += body.friction * shear[k];
  }
  for (int i = 0; i < grid.nodes_x(); ++i) {
    Stress sum{};
    for (int cell = 0; cell < grid.nodes_x(); ++cell) {
      const Stress& one = below[static_cast<std::size_t>(i - cell + grid.nx)];
      for (const Component k : {xx, yy, zz, xz}) sum[k] += P(cell, 1) * one[k];
    }
    for (std::size_t k = 0; k < components; ++k)
      for (int j = 0; j < grid.nodes_y(); ++j) stress[k](i, j) = sum[k];
  }
}

}  // namespace ehl::subsurface
