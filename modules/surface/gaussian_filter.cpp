#include "surface/gaussian_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/constants.hpp"

namespace ehl::surface {
namespace {

/// Width of the weights over the cut-off, for which a wave of that length passes with half of its amplitude: value of
/// ISO 16610-31 for second order; sqrt(ln 2/pi) of ISO 16610-21 and -61.
constexpr double width_of_parabolas = 0.7309;
constexpr double width_of_means = 0.46971863934982566;
/// Distance in widths beyond which the weights are negligible.
constexpr double reach = 3.0;

// Length that each point represents, by the trapezoidal rule.
std::vector<double> shares(std::span<const double> x) {
  const std::size_t n = x.size();
  std::vector<double> result(n);
  for (std::size_t k = 0; k < n; ++k) result[k] = 0.5 * ((k + 1 < n ? x[k + 1] : x[k]) - (k > 0 ? x[k - 1] : x[k]));
  return result;
}

// Constant term of the parabola with these moments, by Cramer's rule; the mean if the points do not determine a
// parabola.
double parabola_at_zero(const double (&m)[5], const double (&b)[3]) {
  const double minor0 = m[2] * m[4] - m[3] * m[3];
  const double minor1 = m[1] * m[4] - m[2] * m[3];
  const double minor2 = m[1] * m[3] - m[2] * m[2];
  const double determinant = m[0] * minor0 - m[1] * minor1 + m[2] * minor2;
  constexpr double singular = 1e-12;
  if (!(determinant > singular * m[0] * m[2] * m[4])) return b[0] / m[0];
  return (b[0] * minor0 - b[1] * minor1 + b[2] * minor2) / determinant;
}

// Weights by distance in points, equal on both sides; only index 0 if the cut-off is below a step.
std::vector<double> weights_of_means(double step, double cut_off, int most) {
  const double width = width_of_means * cut_off;
  std::vector<double> weights;
  for (int k = 0; k <= most && (k == 0 || k * step <= reach * width); ++k)
    weights.push_back(std::exp(-core::pi * (k * step / width) * (k * step / width)));
  return weights;
}

// Weighted mean along one axis: n points with distance `stride` in `from` and `to`.
void average(const std::vector<double>& weights, int n, std::size_t stride, const double* from, double* to) {
  const int side = static_cast<int>(weights.size()) - 1;
  for (int k = 0; k < n; ++k) {
    double sum = 0.0, of_weights = 0.0;
    for (int j = std::max(0, k - side); j <= std::min(n - 1, k + side); ++j) {
      const double w = weights[static_cast<std::size_t>(std::abs(j - k))];
      sum += w * from[static_cast<std::size_t>(j) * stride];
      of_weights += w;
    }
    to[static_cast<std::size_t>(k) * stride] = sum / of_weights;
  }
}

}  // namespace

std::vector<double> long_waves(std::span<const double> x, std::span<const double> z, double cut_off) {
  const std::vector<double> share = shares(x);
  const double width = width_of_parabolas * cut_off;
  std::vector<double> result(x.size());
  std::size_t first = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    while (x[n] - x[first] > reach * width) ++first;
    double m[5] = {}, b[3] = {};
    for (std::size_t k = first; k < x.size() && x[k] - x[n] <= reach * width; ++k) {
      const double u = (x[k] - x[n]) / width;
      double power = share[k] * std::exp(-core::pi * u * u);
      for (int p = 0; p < 5; ++p, power *= u) {
        m[p] += power;
        if (p < 3) b[p] += power * z[k];
      }
    }
    result[n] = parabola_at_zero(m, b);
  }
  return result;
}

Heights long_waves(const Heights& heights, double dx, double dy, double cut_off) {
  const auto nx = static_cast<std::size_t>(heights.nx);
  Heights along = heights;
  const std::vector<double> of_x = weights_of_means(dx, cut_off, heights.nx);
  for (int l = 0; l < heights.ny; ++l) {
    const std::size_t line = static_cast<std::size_t>(l) * nx;
    average(of_x, heights.nx, 1, heights.values.data() + line, along.values.data() + line);
  }
  Heights result = along;
  const std::vector<double> of_y = weights_of_means(dy, cut_off, heights.ny);
  for (std::size_t k = 0; k < nx; ++k) average(of_y, heights.ny, nx, along.values.data() + k, result.values.data() + k);
  return result;
}

}  // namespace ehl::surface
