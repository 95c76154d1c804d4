#include "asperities/flow_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::asperities {
namespace {

// One line of the tables of Patir and Cheng.
struct Coefficients {
  double gamma;
  double C, r, least_l;
  double A1, a1, a2, a3, A2;
};
constexpr std::array<Coefficients, 7> published{{{1.0 / 9.0, 1.48, 0.42, 1.0, 2.046, 1.12, 0.78, 0.03, 1.856},
                                                 {1.0 / 6.0, 1.38, 0.42, 1.0, 1.962, 1.08, 0.77, 0.03, 1.754},
                                                 {1.0 / 3.0, 1.18, 0.42, 0.75, 1.858, 1.01, 0.76, 0.03, 1.561},
                                                 {1.0, 0.90, 0.56, 0.5, 1.899, 0.98, 0.92, 0.05, 1.126},
                                                 {3.0, 0.225, 1.5, 0.5, 1.560, 0.85, 1.13, 0.08, 0.556},
                                                 {6.0, 0.520, 1.5, 0.5, 1.290, 0.62, 1.09, 0.08, 0.388},
                                                 {9.0, 0.870, 1.5, 0.5, 1.011, 0.54, 1.07, 0.08, 0.295}}};
constexpr double far = 5.0;  // l from which on the shear factor is a plain exponential

// A factor and its derivative with respect to l.
struct Both {
  double value, slope;
};

Both pressure_of(const Coefficients& c, double l) {
  const double at = std::max(l, c.least_l);
  const double deviation = c.gamma <= 1.0 ? -c.C * std::exp(-c.r * at) : c.C * std::pow(at, -c.r);
  const double slope = c.gamma <= 1.0 ? -c.r * deviation : -c.r * deviation / at;
  return {1.0 + deviation, l < c.least_l ? 0.0 : slope};
}

Both shear_of(const Coefficients& c, double l) {
  if (l > far) return {c.A2 * std::exp(-0.25 * l), -0.25 * c.A2 * std::exp(-0.25 * l)};
  const double at = std::max(l, c.least_l);
  const double value = c.A1 * std::pow(at, c.a1) * std::exp((c.a3 * at - c.a2) * at);
  return {value, l < c.least_l ? 0.0 : value * (c.a1 / at - c.a2 + 2.0 * c.a3 * at)};
}

template <class Factor>
Both between(double gamma, double l, Factor factor) {
  std::size_t k = 0;
  while (k + 2 < published.size() && gamma > published[k + 1].gamma) ++k;
  const double share = std::log(gamma / published[k].gamma) / std::log(published[k + 1].gamma / published[k].gamma);
  const Both low = factor(published[k], l), high = factor(published[k + 1], l);
  return {low.value + share * (high.value - low.value), low.slope + share * (high.slope - low.slope)};
}

// Slopes that let no cubic overshoot: zero at extremes, else the harmonic mean of Fritsch and Butland (1984).
std::vector<double> slopes_of(std::span<const double> x, std::span<const double> y) {
  std::vector<double> slopes(x.size(), 0.0);
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double left = secant(k - 1), right = secant(k);
    const double near = 2.0 * x[k + 1] - x[k] - x[k - 1], far_side = x[k + 1] + x[k] - 2.0 * x[k - 1];
    if (left * right > 0.0) slopes[k] = (near + far_side) / (near / left + far_side / right);
  }
  return slopes;
}

Both tabulated(const TabulatedFactor& factor, double h) {
  const rheology::Curve& curve = *factor.curve;
  if (h < factor.first_gap) return {curve.y.front(), 0.0};
  if (h > factor.last_gap) {
    const double deviation = (curve.y.back() - 1.0) * (factor.last_gap / h) * (factor.last_gap / h);
    return {1.0 + deviation, -2.0 * deviation / h};
  }
  return {rheology::value(curve, h - factor.first_gap), rheology::slope(curve, h - factor.first_gap)};
}

enum class Direction : std::size_t { x, y };

// The factor and its derivative with respect to H.
Both pressure_at(const FlowFactors& factors, Direction direction, double H) {
  const double h = factors.gap_scale * H;
  if (const auto* model = std::get_if<PatirCheng>(&factors.model)) {
    const double gamma = direction == Direction::x ? model->gamma : 1.0 / model->gamma;
    const Both both = between(gamma, h / factors.sigma, pressure_of);
    return {both.value, both.slope * factors.gap_scale / factors.sigma};
  }
  const Both both = tabulated(std::get<1>(factors.model)[static_cast<std::size_t>(direction)], h);
  return {both.value, both.slope * factors.gap_scale};
}

Both shear_at(const FlowFactors& factors, double H) {
  const auto* model = std::get_if<PatirCheng>(&factors.model);
  if (model == nullptr) return {0.0, 0.0};
  const Both both = between(model->gamma, factors.gap_scale * H / factors.sigma, shear_of);
  return {both.value, both.slope * factors.gap_scale / factors.sigma};
}

}  // namespace

std::string wrong_gamma(double gamma) {
  if (gamma >= least_gamma * (1.0 - 1e-12) && gamma <= greatest_gamma) return {};
  return fmt::format("Peklenik's gamma must be from 1/9 to 9, the range of Patir and Cheng, and is {:.4g}", gamma);
}

double pressure_factor(const PatirCheng& law, double l) { return between(law.gamma, l, pressure_of).value; }
double pressure_factor_slope(const PatirCheng& law, double l) { return between(law.gamma, l, pressure_of).slope; }
double shear_factor(const PatirCheng& law, double l) { return between(law.gamma, l, shear_of).value; }
double shear_factor_slope(const PatirCheng& law, double l) { return between(law.gamma, l, shear_of).slope; }

double contact_factor(double l) { return 0.5 * std::erfc(-l / std::sqrt(2.0)); }
double mean_gap(double l) { return l * contact_factor(l) + std::exp(-0.5 * l * l) / std::sqrt(2.0 * core::pi); }

TabulatedFactor tabulated_factor(std::span<const double> gaps, std::span<const double> factors) {
  std::vector<double> x;
  for (const double gap : gaps) x.push_back(gap - gaps.front());
  rheology::Curve curve = rheology::monotone_curve(x, x);  // for its search table
  curve.y.assign(factors.begin(), factors.end());
  curve.slope = slopes_of(x, factors);
  return {std::make_shared<const rheology::Curve>(std::move(curve)), gaps.front(), gaps.back()};
}

FlowFactors flow_factors(const GapTable& table, double gap_scale) {
  return {.model = std::vector<TabulatedFactor>{tabulated_factor(table.gap, table.phi_x),
                                                tabulated_factor(table.gap, table.phi_y)},
          .gap_scale = gap_scale};
}

void phi_x(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = pressure_at(factors, Direction::x, H[k]).value;
}
void phi_y(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = pressure_at(factors, Direction::y, H[k]).value;
}
void phi_x_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = pressure_at(factors, Direction::x, H[k]).slope;
}
void phi_y_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = pressure_at(factors, Direction::y, H[k]).slope;
}
void phi_s(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = shear_at(factors, H[k]).value;
}
void phi_s_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out) {
  for (std::size_t k = 0; k < H.size(); ++k) out[k] = shear_at(factors, H[k]).slope;
}

}  // namespace ehl::asperities
