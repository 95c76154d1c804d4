#include "asperities/roughness_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace ehl::asperities {
namespace {

// A row of the map along one axis, with its neighbours beyond the edges mirrored.
struct Axis {
  int points, rows;
  std::size_t step, row_step;
  double distance;
};
Axis axis_x(const Cell& c) { return {c.nx, c.ny, 1, static_cast<std::size_t>(c.nx), c.dx}; }
Axis axis_y(const Cell& c) { return {c.ny, c.nx, static_cast<std::size_t>(c.nx), 1, c.dy}; }

template <class Visit>
void for_rows(const Axis& axis, const std::vector<double>& z, Visit visit) {
  for (int r = 0; r < axis.rows; ++r) {
    const std::size_t begin = static_cast<std::size_t>(r) * axis.row_step;
    visit([&, begin](int i) { return z[begin + static_cast<std::size_t>(i) * axis.step]; });
  }
}

// Mean square of the slope and of the curvature of the profiles.
struct Moments {
  double slope = 0.0, curvature = 0.0;
};
Moments moments_of(const Axis& axis, const std::vector<double>& z) {
  Moments m;
  for_rows(axis, z, [&](auto at) {
    for (int i = 0; i + 1 < axis.points; ++i) m.slope += std::pow((at(i + 1) - at(i)) / axis.distance, 2);
    for (int i = 1; i + 1 < axis.points; ++i)
      m.curvature += std::pow((at(i + 1) - 2.0 * at(i) + at(i - 1)) / (axis.distance * axis.distance), 2);
  });
  m.slope /= static_cast<double>(axis.rows) * (axis.points - 1);
  m.curvature /= static_cast<double>(axis.rows) * (axis.points - 2);
  return m;
}

// Distance at which the autocorrelation of the profiles falls to one half, linearly between points.
double half_correlation(const Axis& axis, const std::vector<double>& z, double variance) {
  double before = 1.0;
  for (int lag = 1; lag < axis.points / 2; ++lag) {
    double sum = 0.0;
    for_rows(axis, z, [&](auto at) {
      for (int i = 0; i + lag < axis.points; ++i) sum += at(i) * at(i + lag);
    });
    const double now = sum / (static_cast<double>(axis.rows) * (axis.points - lag) * variance);
    if (now <= 0.5) return axis.distance * (lag - 1 + (before - 0.5) / (before - now));
    before = now;
  }
  return core::unknown;
}

// 2 <z_x z_y>/<z_x^2 + z_y^2>, with the slopes at the middle of four points.
double obliqueness(const Cell& cell, const std::vector<double>& z) {
  double mixed = 0.0, square = 0.0;
  const auto nx = static_cast<std::size_t>(cell.nx);
  for (std::size_t j = 0; j + 1 < static_cast<std::size_t>(cell.ny); ++j)
    for (std::size_t n = j * nx; n + 1 < (j + 1) * nx; ++n) {
      const double x = (z[n + 1] - z[n] + z[n + nx + 1] - z[n + nx]) / cell.dx;
      const double y = (z[n + nx] - z[n] + z[n + nx + 1] - z[n + 1]) / cell.dy;
      mixed += 2.0 * x * y;
      square += x * x + y * y;
    }
  return mixed / square;
}

double direction_share(const Cell& cell, const std::vector<double>& z) {
  std::vector<double> spectrum;
  CosineTransform(cell, 1).forward(z, spectrum);
  double along = 0.0, all = 0.0;
  for (int k = 0; k < cell.nx; ++k)
    for (int l = 0; l < cell.ny; ++l) {
      if (k + l == 0) continue;
      const double qx = cell.wave_number_x(k), qy = cell.wave_number_y(l);
      const double s =
          spectrum[static_cast<std::size_t>(k) * static_cast<std::size_t>(cell.ny) + static_cast<std::size_t>(l)];
      const double power = s * s * (k == 0 ? 0.5 : 1.0) * (l == 0 ? 0.5 : 1.0);
      along += power * qx * qx / (qx * qx + qy * qy);
      all += power;
    }
  return along / all;
}

}  // namespace

RoughnessNumbers roughness_numbers(const Cell& cell, const std::vector<double>& z) {
  RoughnessNumbers numbers;
  double second = 0.0, third = 0.0, fourth = 0.0;
  for (const double height : z) {
    second += height * height;
    third += height * height * height;
    fourth += height * height * height * height;
    numbers.highest = std::max(numbers.highest, height);
  }
  const double count = static_cast<double>(z.size()), variance = second / count;
  numbers.Sq = std::sqrt(variance);
  numbers.skewness = third / count / (variance * numbers.Sq);
  numbers.kurtosis = fourth / count / (variance * variance);
  const Moments x = moments_of(axis_x(cell), z), y = moments_of(axis_y(cell), z);
  numbers.slope = std::sqrt(x.slope + y.slope);
  numbers.share_x = direction_share(cell, z);
  numbers.correlation_x = half_correlation(axis_x(cell), z, variance);
  numbers.correlation_y = half_correlation(axis_y(cell), z, variance);
  numbers.oblique = obliqueness(cell, z);
  numbers.peklenik = numbers.correlation_x / numbers.correlation_y;
  const double m2 = 0.5 * (x.slope + y.slope), m4 = 0.5 * (x.curvature + y.curvature);
  const double eta = m4 / (6.0 * core::pi * std::sqrt(3.0) * m2), beta = 0.375 * std::sqrt(core::pi / m4);
  const double alpha = variance * m4 / (m2 * m2);
  numbers.summit_height = 4.0 * std::sqrt(variance / (core::pi * alpha));
  numbers.summit_sigma = std::sqrt(std::max(0.0, 1.0 - 0.8968 / alpha) * variance);
  numbers.eta_beta_sigma = eta * beta * numbers.summit_sigma;
  numbers.sigma_over_beta = numbers.summit_sigma / beta;
  return numbers;
}

double small_roughness_factor(double Sq_over_h, double share) {
  return 1.0 + 3.0 * Sq_over_h * Sq_over_h * (1.0 - 3.0 * share);
}

}  // namespace ehl::asperities
