#include "machines/gear.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "machines/number.hpp"

namespace ehl::machines {
namespace {

using core::pi;

double involute(double angle) { return std::tan(angle) - angle; }

// Newton's method for tan(angle) - angle = value, a convex function: it converges from above. NaN if there is no root.
double angle_of_involute(double value) {
  if (!(value > 0.0)) return core::unknown;
  // inv(x) > x^3/3, so the root lies below this initial value, and below 90 degrees.
  double angle = std::min(std::cbrt(3.0 * value), std::atan(value + 0.5 * pi));
  for (double before = pi; angle < before;) {
    before = angle;
    angle -= (involute(angle) - value) / (std::tan(angle) * std::tan(angle));
  }
  return angle;
}

}  // namespace

PathOfContact path_of_contact(const Gears& gears) {
  const double alpha = gears.pressure_angle * degree;
  const double teeth = gears.teeth1 + gears.teeth2, shift = gears.shift1 + gears.shift2;
  const double working_angle =
      shift == 0.0 ? alpha : angle_of_involute(involute(alpha) + 2.0 * std::tan(alpha) * shift / teeth);
  const auto base_radius = [&](int z) { return 0.5 * gears.module * z * std::cos(alpha); };
  // Distance along the line of action from the base circle to the tip.
  const auto reach = [](double tip, double base) { return std::sqrt((tip - base) * (tip + base)); };
  PathOfContact path{};
  path.working_angle = working_angle / degree;
  path.base_radius1 = base_radius(gears.teeth1);
  path.base_radius2 = base_radius(gears.teeth2);
  path.centre_distance = (path.base_radius1 + path.base_radius2) / std::cos(working_angle);
  path.tip_alteration = path.centre_distance / gears.module - 0.5 * teeth - shift;
  const auto tip_radius = [&](int z, double x) {
    return gears.module * (0.5 * z + gears.addendum + x + path.tip_alteration);
  };
  path.tip_radius1 = tip_radius(gears.teeth1, gears.shift1);
  path.tip_radius2 = tip_radius(gears.teeth2, gears.shift2);
  const auto tip_thickness = [&](double tip, double base, int z, double x) {
    return 2.0 * tip * ((0.5 * pi + 2.0 * x * std::tan(alpha)) / z + involute(alpha) - involute(std::acos(base / tip)));
  };
  path.tip_thickness1 = tip_thickness(path.tip_radius1, path.base_radius1, gears.teeth1, gears.shift1);
  path.tip_thickness2 = tip_thickness(path.tip_radius2, path.base_radius2, gears.teeth2, gears.shift2);
  path.base_pitch = pi * gears.module * std::cos(alpha);
  path.length_T1T2 = path.centre_distance * std::sin(working_angle);
  path.A = path.length_T1T2 - reach(path.tip_radius2, path.base_radius2);
  path.E = reach(path.tip_radius1, path.base_radius1);
  path.B = path.E - path.base_pitch;
  path.C = path.base_radius1 * std::tan(working_angle);
  path.D = path.A + path.base_pitch;
  path.contact_ratio = (path.E - path.A) / path.base_pitch;
  return path;
}

double share(const PathOfContact& path, double s, Sharing sharing) {
  if (sharing == Sharing::none || (s >= path.B && s <= path.D)) return 1.0;
  const double from_the_end = s < path.B ? (s - path.A) / (path.B - path.A) : (path.E - s) / (path.E - path.D);
  return (1.0 + from_the_end) / 3.0;
}

Mesh mesh_at(const Gears& gears, const PathOfContact& path, double s, double omega1) {
  const double rho1 = s, rho2 = path.length_T1T2 - s;
  const double omega2 = omega1 * gears.teeth1 / gears.teeth2;
  // The sliding speed is computed from the distance to the pitch point, so that it is exactly zero there.
  const double u1 = omega1 * rho1, sliding = (omega1 + omega2) * (s - path.C);
  return {rho1, rho2, rho1 * rho2 / (rho1 + rho2), u1, u1 - sliding};
}

}  // namespace ehl::machines
