#include "contact/ellipse.hpp"

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/constants.hpp"

namespace ehl::contact {
namespace {

using core::pi;

/// Complete elliptic integrals at m = 1 - 1/kappa^2 as K = B + D and E = B + (1 - m) D. With B and D there is no
/// cancellation near the circle; Carlson's forms take 1 - m as argument.
struct Integrals {
  double K;
  double B;  ///< (E - (1 - m) K)/m
  double D;  ///< (K - E)/m
};
Integrals integrals(double kappa) {
  const double one_less_m = 1.0 / (kappa * kappa);
  const double K = boost::math::ellint_rf(0.0, one_less_m, 1.0);
  const double D = boost::math::ellint_rd(0.0, one_less_m, 1.0) / 3.0;
  return {K, K - D, D};
}

// Longer over shorter semi-axis: root of kappa^2 B/D = R_s/R_e >= 1, close to (R_s/R_e)^(2/3).
double kappa_of(double radius_ratio) {
  const auto excess = [&](double kappa) {
    const Integrals I = integrals(kappa);
    return kappa * kappa * I.B / I.D - radius_ratio;
  };
  std::uintmax_t steps = 100;
  const auto [below, above] = boost::math::tools::bracket_and_solve_root(
      excess, std::cbrt(radius_ratio * radius_ratio), 2.0, true, boost::math::tools::eps_tolerance<double>(), steps);
  return std::max(0.5 * (below + above), 1.0);
}

struct Direction {
  double cosine;
  double sine;
};
// Exact for entrainment along an axis, where the contact is symmetric.
Direction direction(const Ellipse& shape) {
  if (shape.angle == 0.0 || circular(shape)) return {1.0, 0.0};
  if (std::abs(shape.angle) == 90.0) return {0.0, 1.0};
  const double angle = shape.angle * pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

// along x^2 + across y^2, transformed to the frame of the entrainment.
core::QuadraticForm turned(const Ellipse& shape, double along, double across) {
  const auto [c, s] = direction(shape);
  return {c * c * along + s * s * across, 2.0 * s * c * (across - along), s * s * along + c * c * across};
}

}  // namespace

Ellipse ellipse(double radius_ratio, double angle) {
  if (radius_ratio == 1.0) return {};
  const bool wide = radius_ratio < 1.0;
  const double longer = kappa_of(wide ? 1.0 / radius_ratio : radius_ratio);
  const auto [K, B, D] = integrals(longer);
  // (longer/a_circle)^3 = (4/pi) (R_e/R_x) (kappa^2 E - K)/m, and (kappa^2 E - K)/m = kappa^2 B.
  const double long_axis = std::cbrt(4.0 / pi * longer * longer * B * (wide ? 1.0 : 1.0 / radius_ratio));
  Ellipse shape;
  shape.radius_ratio = radius_ratio;
  shape.angle = angle;
  shape.kappa = wide ? longer : 1.0 / longer;
  shape.a = wide ? long_axis / longer : long_axis;
  shape.p_h = 1.0 / (shape.a * shape.a * shape.kappa);
  // approach = 2 p_h (shorter semi-axis) K/E', and p_h R_x/(E' a) = 1/pi for the circle.
  shape.approach = 2.0 / pi * shape.p_h / shape.a * K * std::min(1.0, shape.kappa);
  return shape;
}

Ellipse line_contact() {
  return {.radius_ratio = 0.0,
          .angle = 0.0,
          .kappa = std::numeric_limits<double>::infinity(),
          .a = 1.0,
          .p_h = 0.5 * pi,
          .approach = 0.25 + 0.5 * std::numbers::ln2};
}

Ellipse roller_contact(double length) {
  Ellipse shape = line_contact();
  shape.length = length;
  shape.kappa = 0.5 * length;
  shape.p_h = 0.25 * pi;
  shape.approach += 0.5 * std::log(length);
  return shape;
}

core::QuadraticForm gap(const Ellipse& shape) { return turned(shape, 0.5, 0.5 * shape.radius_ratio); }

core::QuadraticForm outline(const Ellipse& shape) {
  return turned(shape, 1.0, line(shape) ? 0.0 : 1.0 / (shape.kappa * shape.kappa));
}

Extent extent(const Ellipse& shape) {
  if (line(shape)) return {1.0, shape.kappa, 1.0};
  const auto [c, s] = direction(shape);
  return {std::hypot(c, s * shape.kappa), std::hypot(s, c * shape.kappa), std::min(1.0, shape.kappa)};
}

double elastic_factor(const Ellipse& shape) { return 2.0 / (pi * pi) * (shape.p_h / shape.a); }

double relative_load(const Ellipse& shape) {
  if (roller(shape)) return 0.75 * shape.length;
  return line(shape) ? 0.75 : shape.kappa;
}

double load(const Ellipse& shape) { return 2.0 * pi / 3.0 * relative_load(shape); }

AlongEntrainment along_entrainment(const Ellipse& shape, double M, double L) {
  const core::QuadraticForm H = gap(shape);
  const double q = 2.0 * H.XX;  // R_x/R_e
  return {M * std::pow(q, 1.25), L * std::pow(q, 0.25), H.YY / H.XX, 1.0 / std::sqrt(q)};
}

}  // namespace ehl::contact
