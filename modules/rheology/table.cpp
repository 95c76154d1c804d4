#include "rheology/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ehl::rheology {
namespace {

// Slope at an end from its two nearest intervals: that of the parabola if it is positive and does not let the cubic
// overshoot, else that of the nearest interval. It is never zero, because the curve is continued with it.
double end_slope(double h_near, double h_far, double secant_near, double secant_far) {
  const double parabola = ((2.0 * h_near + h_far) * secant_near - h_near * secant_far) / (h_near + h_far);
  return parabola > 0.0 ? std::min(parabola, 3.0 * secant_near) : secant_near;
}

// Interval that contains an x inside the curve.
std::size_t interval(const Curve& curve, double x) {
  const auto box = std::min(static_cast<std::size_t>(x * curve.boxes_per_x), curve.first.size() - 1);
  auto k = static_cast<std::size_t>(curve.first[box]);
  while (k > 0 && x < curve.x[k]) --k;  // the box of x is exact only up to rounding
  while (k + 2 < curve.x.size() && x >= curve.x[k + 1]) ++k;
  return k;
}

}  // namespace

Curve monotone_curve(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  Curve curve{.x = {x.begin(), x.end()}, .y = {y.begin(), y.end()}, .slope = std::vector<double>(n)};
  const auto h = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / h(k); };
  curve.slope[0] = end_slope(h(0), h(1), secant(0), secant(1));
  curve.slope[n - 1] = end_slope(h(n - 2), h(n - 3), secant(n - 2), secant(n - 3));
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double near = 2.0 * h(k) + h(k - 1), far = h(k) + 2.0 * h(k - 1);
    curve.slope[k] = (near + far) / (near / secant(k - 1) + far / secant(k));
  }
  const std::size_t boxes = 4 * n;
  curve.boxes_per_x = static_cast<double>(boxes) / x[n - 1];
  curve.first.resize(boxes, 0);
  for (std::size_t box = 0, k = 0; box < boxes; ++box) {
    while (k + 2 < n && x[k + 1] * curve.boxes_per_x <= static_cast<double>(box)) ++k;
    curve.first[box] = static_cast<int>(k);
  }
  return curve;
}

double value(const Curve& curve, double x) {
  if (!(x > 0.0)) return curve.y.front() + curve.slope.front() * x;
  if (!(x < curve.x.back())) return curve.y.back() + curve.slope.back() * (x - curve.x.back());
  const std::size_t k = interval(curve, x);
  const double h = curve.x[k + 1] - curve.x[k];
  const double t = (x - curve.x[k]) / h;
  const double rise = curve.y[k + 1] - curve.y[k];
  const double left = h * curve.slope[k] - rise, right = rise - h * curve.slope[k + 1];
  return curve.y[k] + t * (rise + (1.0 - t) * (left + t * (right - left)));
}

double slope(const Curve& curve, double x) {
  if (!(x > 0.0)) return curve.slope.front() + 0.0 * x;
  if (!(x < curve.x.back())) return curve.slope.back();
  const std::size_t k = interval(curve, x);
  const double h = curve.x[k + 1] - curve.x[k];
  const double t = (x - curve.x[k]) / h;
  const double rise = curve.y[k + 1] - curve.y[k];
  const double left = h * curve.slope[k] - rise, right = rise - h * curve.slope[k + 1];
  return (rise + (1.0 - 2.0 * t) * (left + t * (right - left)) + t * (1.0 - t) * (right - left)) / h;
}

TabulatedViscosity make_tabulated_viscosity(std::span<const double> p, std::span<const double> eta, double p_h) {
  std::vector<double> log_eta_bar;
  for (const double here : eta) log_eta_bar.push_back(std::log(here / eta.front()));
  return {std::make_shared<const Curve>(monotone_curve(p, log_eta_bar)), p_h};
}

TabulatedDensity make_tabulated_density(std::span<const double> p, std::span<const double> rho, double p_h) {
  std::vector<double> rho_bar;
  for (const double here : rho) rho_bar.push_back(here / rho.front());
  return {std::make_shared<const Curve>(monotone_curve(p, rho_bar)), p_h};
}

void log_eta(const TabulatedViscosity& law, std::span<const double> P, std::span<double> out) {
  for (std::size_t k = 0; k < P.size(); ++k) out[k] = value(*law.curve, law.p_h * P[k]);
}
void log_eta_slope(const TabulatedViscosity& law, std::span<const double> P, std::span<double> out) {
  for (std::size_t k = 0; k < P.size(); ++k) out[k] = law.p_h * slope(*law.curve, law.p_h * P[k]);
}
void rho(const TabulatedDensity& law, std::span<const double> P, std::span<double> out) {
  for (std::size_t k = 0; k < P.size(); ++k) out[k] = value(*law.curve, law.p_h * P[k]);
}
void rho_slope(const TabulatedDensity& law, std::span<const double> P, std::span<double> out) {
  for (std::size_t k = 0; k < P.size(); ++k) out[k] = law.p_h * slope(*law.curve, law.p_h * P[k]);
}

}  // namespace ehl::rheology
