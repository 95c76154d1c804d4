#include "kernel/coating.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::kernel {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

double plane_modulus(const Material& material) { return material.E / (1.0 - material.nu * material.nu); }

/// R - R(infinity) is below rounding from here on.
constexpr double largest_q = 32.0;
/// Waves that are integrated one after another, and those after them whose alternating sums are averaged.
constexpr int waves_in_full = 30, waves_averaged = 20;
/// The table ends at asinh(rho) = table_end. Beyond, the smooth part is that of rho -> infinity.
constexpr double table_step = 0.03, table_end = 14.0;
/// Points of the interpolation, and those of them before the interval.
constexpr int points = 8, before = 3;

// Integral of f(q) wave(q rho) from 0 to infinity; wave is J0 or the cosine, which changes its sign near (n + phase)
// pi. Panels are no longer than a half wave and their distance from the pole of f, near q = -pole. A long series of
// waves alternates, and its sum is the repeated mean of the partial sums (Euler's transformation).
template <class Function, class Wave>
double transform(double rho, double phase, double pole, Function f, Wave wave) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  const auto panel = [&](double from, double to) {
    return Gauss::integrate([&](double q) { return f(q) * wave(q * rho); }, from, to);
  };
  const double half_wave = core::pi / std::max(rho, 1e-3);
  const double end = std::min(largest_q, (waves_in_full + phase) * half_wave);
  double sum = 0.0;
  for (double q = 0.0; q < end;) {
    const double next = std::min(end, q + std::min({half_wave, 0.5, 0.5 * pole + q}));
    sum += panel(q, next);
    q = next;
  }
  if (end == largest_q) return sum;
  std::array<double, waves_averaged> sums;
  for (int n = 0; n < waves_averaged; ++n) {
    sum += panel(end + n * half_wave, end + (n + 1) * half_wave);
    sums[at(n)] = sum;
  }
  for (int left = waves_averaged - 1; left > 0; --left)
    for (int n = 0; n < left; ++n) sums[at(n)] = 0.5 * (sums[at(n)] + sums[at(n + 1)]);
  return sums[0];
}

}  // namespace

// All differences of nearly equal numbers are written out: a stiff coating has lambda and kappa near 1.
double response(const Coating& coating, double q) {
  const auto& [layer, body, thickness, share] = coating;
  const double mu = layer.E * (1.0 + body.nu) / (body.E * (1.0 + layer.nu));
  const double one_less_kappa = 4.0 * (1.0 - layer.nu) / (mu + 3.0 - 4.0 * layer.nu), kappa = 1.0 - one_less_kappa;
  const double one_less_lambda = 4.0 * (1.0 - layer.nu) / (1.0 + mu * (3.0 - 4.0 * body.nu));
  const double lambda = 1.0 - one_less_lambda;
  const double less = -std::expm1(-2.0 * q), e = 1.0 - less;
  const double above =
      one_less_lambda + one_less_kappa * lambda + lambda * kappa * less * (1.0 + e) + 4.0 * kappa * q * e;
  const double below = (one_less_lambda + lambda * less) * (one_less_kappa + kappa * less) - 4.0 * kappa * q * q * e;
  return plane_modulus(body) / plane_modulus(layer) * above / below - 1.0;
}
double local_response(const Coating& coating) {
  return plane_modulus(coating.body) / plane_modulus(coating.coating) - 1.0;
}

SmoothPart::SmoothPart(const Coating& coating, bool plane)
    : plane_(plane), thickness_(coating.thickness), local_(coating.share * local_response(coating)) {
  // The film of a stiff coating is stretched over a length of thickness times the ratio of the moduli.
  const double pole = std::min(1.0, plane_modulus(coating.body) / plane_modulus(coating.coating));
  const auto above = [&](double q) { return coating.share * response(coating, q) - local_; };
  const auto above_line = [&](double q) { return (above(q) + local_ * std::exp(-q)) / q; };
  const int last = static_cast<int>(table_end / table_step) + points;
  for (int n = -before; n <= last; ++n) {
    const double rho = std::abs(std::sinh(n * table_step));
    table_.push_back(plane ? transform(rho, 0.5, pole, above_line, [](double x) { return std::cos(x); })
                           : std::hypot(1.0, rho) * transform(rho, -0.25, pole, above, [](double x) {
                               return boost::math::cyl_bessel_j(0, x);
                             }));
  }
  if (plane) at_one_ = (*this)(1.0);
}

double SmoothPart::operator()(double r) const {
  const double rho = r / thickness_;
  const double place = std::min(std::asinh(rho), table_end) / table_step;
  const int interval = static_cast<int>(place);
  const double* values = table_.data() + interval;
  const double t = place - interval + before;
  // Lagrange's polynomial: products of the distances from the left and from the right.
  static constexpr double weights[points] = {-1.0 / 5040, 1.0 / 720, -1.0 / 240, 1.0 / 144,
                                             -1.0 / 144,  1.0 / 240, -1.0 / 720, 1.0 / 5040};
  double left[points], right = 1.0, sum = 0.0;
  left[0] = 1.0;
  for (int k = 1; k < points; ++k) left[k] = left[k - 1] * (t - (k - 1));
  for (int k = points - 1; k >= 0; --k) {
    sum += weights[k] * left[k] * right * values[k];
    right *= t - k;
  }
  if (plane_) return sum + local_ * (std::log(thickness_) + 0.5 * std::log1p(rho * rho)) - at_one_;
  return sum / (thickness_ * std::sqrt(1.0 + rho * rho));
}

}  // namespace ehl::kernel
