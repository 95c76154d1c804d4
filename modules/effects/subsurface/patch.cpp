#include "effects/subsurface/patch.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::subsurface {
namespace {

using Corner = Stress (*)(double u, double v, double z, double nu);

Stress over_corners(Corner corner, double x, double y, double z, double half_x, double half_y, double nu) {
  const Stress right_upper = corner(x - half_x, y - half_y, z, nu);
  const Stress left_lower = corner(x + half_x, y + half_y, z, nu);
  const Stress left_upper = corner(x + half_x, y - half_y, z, nu);
  const Stress right_lower = corner(x - half_x, y + half_y, z, nu);
  Stress stress{};
  for (std::size_t k = 0; k < components; ++k)
    stress[k] = (right_upper[k] + left_lower[k] - left_upper[k] - right_lower[k]) / (2.0 * core::pi);
  return stress;
}

}  // namespace

// With V = int p/R and chi = int p ln(R + z) over the rectangle (Love):
//   2 pi sigma_xx = 2 nu V_z - z V_xx - (1 - 2 nu) chi_xx,   2 pi sigma_zz = V_z - z V_zz,
//   2 pi tau_xy = -(1 - 2 nu) chi_xy - z V_xy,               2 pi tau_xz = -z V_xz.
// The terms below are the antiderivatives of V_z, V_xx, .. in u and v.
Stress normal_corner(double u, double v, double z, double nu) {
  const double R = std::sqrt(u * u + v * v + z * z);
  const double R_minus_z = (u * u + v * v) / (R + z);
  const double a = u * u + z * z, b = v * v + z * z;
  const double V_z = -std::atan2(u * v, z * R);
  const double z_V_xx = -u * v * z / (a * R);
  const double z_V_yy = -u * v * z / (b * R);
  // atan(v/u) - atan(v z/(u R)), written without the jump of either term at u = 0.
  const double chi_xx = std::atan2(u * v * R_minus_z, u * u * R + v * v * z);
  const double chi_yy = std::atan2(u * v * R_minus_z, v * v * R + u * u * z);
  const double compressible = 1.0 - 2.0 * nu;
  Stress s{};
  s[xx] = 2.0 * nu * V_z - z_V_xx - compressible * chi_xx;
  s[yy] = 2.0 * nu * V_z - z_V_yy - compressible * chi_yy;
  s[zz] = V_z + z_V_xx + z_V_yy;
  s[xy] = -compressible * std::log(R + z) - z / R;
  s[xz] = z * z * v / (a * R);
  s[yz] = z * z * u / (b * R);
  return s;
}

// With V as above but of q, F = int q ln(R + z), F1 = int q (z ln(R + z) - R):
//   2 pi sigma_xx = 2 (1 + nu) V_x + 2 nu F1_xxx - z F_xxx,   2 pi sigma_yy = 2 nu V_x + 2 nu F1_xyy - z F_xyy,
//   2 pi sigma_zz = -z V_xz,   2 pi tau_xy = V_y + 2 nu F1_xxy - z F_xxy,
//   2 pi tau_xz = V_z - z V_xx,   2 pi tau_yz = -z V_xy.
Stress shear_corner(double u, double v, double z, double nu) {
  const double R = std::sqrt(u * u + v * v + z * z);
  const double a = u * u + z * z;
  // ln(R + v) and ln(R + u), except for terms that cancel in the sum over the corners; also accurate for large negative
  // v, u.
  const double ln_R_v = std::asinh(v / std::sqrt(a));
  const double ln_R_u = std::asinh(u / std::sqrt(v * v + z * z));
  const double v_share = v / (R + z), u_share = u / (R + z);
  const double z_z_v = z * z * v / (a * R);
  Stress s{};
  s[xx] = 2.0 * ln_R_v + 2.0 * nu * v_share + z / R * v_share - z_z_v;
  s[yy] = 2.0 * nu * (ln_R_v - v_share) - z / R * v_share;
  s[zz] = z_z_v;
  s[xy] = ln_R_u - 2.0 * nu * u_share - z / R * u_share;
  s[xz] = -std::atan2(u * v, z * R) + u * v * z / (a * R);
  s[yz] = -z / R;
  return s;
}

Stress normal_patch(double x, double y, double z, double half_x, double half_y, double nu) {
  return over_corners(normal_corner, x, y, z, half_x, half_y, nu);
}

Stress shear_patch(double x, double y, double z, double half_x, double half_y, double nu) {
  return over_corners(shear_corner, x, y, z, half_x, half_y, nu);
}

namespace {

// Second invariant of the deviator.
double J2(const Stress& s) {
  const double one = s[xx] - s[yy], two = s[yy] - s[zz], three = s[zz] - s[xx];
  return (one * one + two * two + three * three) / 6.0 + s[xy] * s[xy] + s[xz] * s[xz] + s[yz] * s[yz];
}

}  // namespace

double mises(const Stress& stress) { return std::sqrt(3.0 * J2(stress)); }

// Principal values of the deviator: 2 sqrt(J2/3) cos(angle + 2 pi k/3), k = -1, 0, 1, 0 <= angle <= pi/3.
double largest_shear(const Stress& s) {
  const double second = J2(s);
  if (second == 0.0) return 0.0;
  const double mean = (s[xx] + s[yy] + s[zz]) / 3.0;
  const double dx = s[xx] - mean, dy = s[yy] - mean, dz = s[zz] - mean;
  const double third =
      dx * dy * dz + 2.0 * s[xy] * s[yz] * s[xz] - dx * s[yz] * s[yz] - dy * s[xz] * s[xz] - dz * s[xy] * s[xy];
  const double cosine = 1.5 * std::sqrt(3.0) * third / (second * std::sqrt(second));
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / 3.0;
  return std::sqrt(second) * std::sin(angle + core::pi / 3.0);
}

}  // namespace ehl::subsurface
