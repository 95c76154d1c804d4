#include "contact/ellipse.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::contact {
namespace {

using core::pi;

/// K = B + D and E = B + (1 - m) D: with these nothing cancels as the ellipse becomes a circle.
struct Integrals {
  double K;
  double B;  ///< (E - (1 - m) K)/m
  double D;  ///< (K - E)/m
};

// By the arithmetic-geometric mean: K = pi/(2 agm(1, 1/kappa)), (K - E)/K = sum of 2^(n-1) c_n^2, c_0^2 = m; here all
// terms over m.
Integrals integrals(double kappa) {
  double mean = 1.0, geometric = 1.0 / kappa;
  const double m = (1.0 - geometric) * (1.0 + geometric);
  double c2_over_m = 1.0, sum = 0.5, weight = 0.5;
  constexpr int enough = 40;  // it converges quadratically
  for (int n = 0; n < enough && mean != geometric; ++n) {
    const double next = 0.5 * (mean + geometric);
    const double root = std::sqrt(mean * geometric);
    // c_(n+1) = c_n^2/(4 a_(n+1))
    c2_over_m *= c2_over_m * m / (16.0 * next * next);
    weight *= 2.0;
    sum += weight * c2_over_m;
    if (next == mean || c2_over_m == 0.0) break;
    mean = next;
    geometric = root;
  }
  const double K = 0.5 * pi / mean;
  return {K, K * (1.0 - sum), K * sum};
}

// [kappa^2 E - K]/[K - E] = kappa^2 B/D.
double radius_ratio_of(double kappa) {
  const Integrals I = integrals(kappa);
  return kappa * kappa * I.B / I.D;
}

// Longer over shorter semi-axis, from R_s/R_e >= 1. The logarithm of the ratio of radii grows with that of kappa by
// between 3/2 and 2, nearly as a straight line.
double kappa_of(double radius_ratio) {
  const double target = std::log(radius_ratio);
  double kappa = std::exp(target * 2.0 / 3.0);
  double step = 1.0;
  constexpr double rounding = 1e-16;
  for (int n = 0; n < 100 && std::abs(step) > rounding; ++n) {
    step = (target - std::log(radius_ratio_of(kappa))) / 1.75;
    kappa *= std::exp(step);
  }
  return std::max(kappa, 1.0);
}

struct Direction {
  double cosine;
  double sine;
};
// Exact along the axes, where the contact is symmetric.
Direction direction(const Ellipse& shape) {
  if (shape.angle == 0.0 || circular(shape)) return {1.0, 0.0};
  if (std::abs(shape.angle) == 90.0) return {0.0, 1.0};
  const double angle = shape.angle * pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

// along x^2 + across y^2 in the frame of the entrainment.
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

core::QuadraticForm gap(const Ellipse& shape) { return turned(shape, 0.5, 0.5 * shape.radius_ratio); }

core::QuadraticForm outline(const Ellipse& shape) { return turned(shape, 1.0, 1.0 / (shape.kappa * shape.kappa)); }

Extent extent(const Ellipse& shape) {
  const auto [c, s] = direction(shape);
  return {std::hypot(c, s * shape.kappa), std::hypot(s, c * shape.kappa), std::min(1.0, shape.kappa)};
}

double elastic_factor(const Ellipse& shape) { return 2.0 / (pi * pi) * (shape.p_h / shape.a); }

double load(const Ellipse& shape) { return 2.0 * pi / 3.0 * shape.kappa; }

AlongEntrainment along_entrainment(const Ellipse& shape, double M, double L) {
  const core::QuadraticForm H = gap(shape);
  const double q = 2.0 * H.XX;  // R_x/R_e
  return {M * std::pow(q, 1.25), L * std::pow(q, 0.25), H.YY / H.XX, 1.0 / std::sqrt(q)};
}

}  // namespace ehl::contact
