#include "machines/spline.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ehl::machines {

// With m the second derivatives, d the distances and r the slopes of the chords:
//   d_{i-1} m_{i-1} + 2 (d_{i-1} + d_i) m_i + d_i m_{i+1} = 6 (r_i - r_{i-1}),
// and at the ends 2 d m_0 + d m_1 = 6 (r_0 - 0), the same mirrored: Thomas' algorithm.
Spline clamped_spline(std::vector<double> x, std::vector<double> y) {
  const std::size_t last = x.size() - 1;
  const auto distance = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto chord = [&](std::size_t k) { return (y[k + 1] - y[k]) / distance(k); };
  std::vector<double> above(x.size(), 0.0), second(x.size(), 0.0);
  for (std::size_t k = 0; k <= last; ++k) {
    const double before = k > 0 ? distance(k - 1) : 0.0, after = k < last ? distance(k) : 0.0;
    const double kink = (k < last ? chord(k) : 0.0) - (k > 0 ? chord(k - 1) : 0.0);
    const double pivot = 2.0 * (before + after) - (k > 0 ? before * above[k - 1] : 0.0);
    above[k] = after / pivot;
    second[k] = (6.0 * kink - (k > 0 ? before * second[k - 1] : 0.0)) / pivot;
  }
  for (std::size_t k = last; k-- > 0;) second[k] -= above[k] * second[k + 1];
  return {std::move(x), std::move(y), std::move(second)};
}

Spline periodic_spline(const std::vector<double>& x, const std::vector<double>& y) {
  // What the ends of a clamped spline do decays by 2 + sqrt(3) from point to point.
  constexpr std::size_t enough = 40;
  const std::size_t points = x.size() - 1;
  const int more = static_cast<int>((enough + points - 1) / points);
  const double period = x.back() - x.front();
  std::vector<double> far_x, far_y;
  for (int n = -more; n <= more; ++n)
    for (std::size_t k = 0; k < points; ++k) {
      far_x.push_back(x[k] + n * period);
      far_y.push_back(y[k]);
    }
  const Spline far = clamped_spline(std::move(far_x), std::move(far_y));
  const auto from = far.second.begin() + static_cast<std::ptrdiff_t>(points) * more;
  Spline spline{x, y, {from, from + static_cast<std::ptrdiff_t>(points)}};
  spline.second.push_back(spline.second.front());
  return spline;
}

SplineValue at(const Spline& spline, double x) {
  const auto above = std::upper_bound(spline.x.begin() + 1, spline.x.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - spline.x.begin()) - 1;
  const double d = spline.x[k + 1] - spline.x[k];
  const double right = (x - spline.x[k]) / d, left = 1.0 - right;
  const double m0 = spline.second[k], m1 = spline.second[k + 1];
  return {left * spline.y[k] + right * spline.y[k + 1] +
              d * d / 6.0 * (left * (left * left - 1.0) * m0 + right * (right * right - 1.0) * m1),
          (spline.y[k + 1] - spline.y[k]) / d +
              d / 6.0 * ((1.0 - 3.0 * left * left) * m0 + (3.0 * right * right - 1.0) * m1),
          left * m0 + right * m1};
}

}  // namespace ehl::machines
