#include "kernel/influence.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "kernel/cell_quadrature.hpp"

namespace ehl::kernel {
namespace {

// ln[(s2 + r2)/(s1 + r1)] where r2^2 - r1^2 = s2^2 - s1^2. Both differences are known without cancellation, so that
// log1p keeps all digits.
double log_ratio(double s1, double s2, double r1, double r2) {
  const double ds = s2 - s1;
  return std::log1p((ds + ds * (s1 + s2) / (r1 + r2)) / (s1 + r1));
}

// Integral of 1/r over [x1, x2] x [y1, y2] with 0 <= x1 < x2, 0 <= y1 < y2, seen from the origin.
double rectangle(double x1, double x2, double y1, double y2) {
  const double r11 = std::hypot(x1, y1), r12 = std::hypot(x1, y2);
  const double r21 = std::hypot(x2, y1), r22 = std::hypot(x2, y2);
  double sum = y2 * log_ratio(x1, x2, r12, r22) + x2 * log_ratio(y1, y2, r21, r22);
  if (y1 > 0.0) sum -= y1 * log_ratio(x1, x2, r11, r21);
  if (x1 > 0.0) sum -= x1 * log_ratio(y1, y2, r11, r12);
  return sum;
}

// The closed form holds for one quadrant: cells that contain an axis through the observation point are cut along it.
double closed_form(int ax, int ay, double hx, double hy) {
  const double factor = (ax == 0 ? 2.0 : 1.0) * (ay == 0 ? 2.0 : 1.0);
  const double x1 = ax == 0 ? 0.0 : (ax - 0.5) * hx;
  const double y1 = ay == 0 ? 0.0 : (ay - 0.5) * hy;
  return factor * rectangle(x1, (ax + 0.5) * hx, y1, (ay + 0.5) * hy);
}

inline double inverse_distance(double x, double y) { return 1.0 / std::sqrt(x * x + y * y); }

template <int points>
void fill_far(double X, double hx, double hy, int every_y, int begin, int end, double* K) {
#pragma omp simd
  for (int d = begin; d < end; ++d)
    K[d] = integrate_over_cell<points>(X, static_cast<double>(d * every_y) * hy, hx, hy, inverse_distance);
}

// First d with hypot(X, d step) >= distance, at most n.
int first_beyond(double distance, double X, double step, int n) {
  int d = X >= distance ? 0 : static_cast<int>(std::sqrt(distance * distance - X * X) / step) + 1;
  while (d > 0 && std::hypot(X, (d - 1) * step) >= distance) --d;
  return std::min(d, n);
}

void fill_row(int dx, int every_y, int n, double hx, double hy, double* K) {
  const double X = dx * hx, step = every_y * hy, cell = std::max(hx, hy);
  const int six = first_beyond(distance_for_6 * cell, X, step, n);
  const int four = first_beyond(distance_for_4 * cell, X, step, n);
  const int three = first_beyond(distance_for_3 * cell, X, step, n);
  for (int d = 0; d < six; ++d) K[d] = closed_form(dx, d * every_y, hx, hy);
  fill_far<6>(X, hx, hy, every_y, six, four, K);
  fill_far<4>(X, hx, hy, every_y, four, three, K);
  fill_far<3>(X, hx, hy, every_y, three, n, K);
}

// f(x+h, y) + f(x-h, y) - 2 f(x, y) for f = 1/r. Every difference of two roots is written as the difference of their
// squares over their sum; the remaining terms are of the size of the result.
double second_difference(double x, double y, double h) {
  const double r = std::hypot(x, y), rp = std::hypot(x + h, y), rm = std::hypot(x - h, y);
  const double ap = 1.0 / (r * rp * (r + rp)), am = 1.0 / (r * rm * (r + rm));
  return h * h * (8.0 * x * x * (r + rp + rm) * ap * am * r / (rp + rm) - ap - am);
}

template <int points>
double integrate_difference(double X, double Y, double hx, double hy) {
  return integrate_over_cell<points>(X, Y, hx, hy, [=](double x, double y) {
    return -0.25 * (second_difference(x, y, hx) + second_difference(y, x, hy));
  });
}

}  // namespace

double influence(int d_x, int d_y, double hx, double hy) {
  const int ax = std::abs(d_x), ay = std::abs(d_y);
  const double X = ax * hx, Y = ay * hy, distance = std::hypot(X, Y) / std::max(hx, hy);
  if (distance < distance_for_6) return closed_form(ax, ay, hx, hy);
  if (distance < distance_for_4) return integrate_over_cell<6>(X, Y, hx, hy, inverse_distance);
  if (distance < distance_for_3) return integrate_over_cell<4>(X, Y, hx, hy, inverse_distance);
  return integrate_over_cell<3>(X, Y, hx, hy, inverse_distance);
}

InfluenceTable influence_table(int n_x, int n_y, double hx, double hy, int every_x, int every_y) {
  InfluenceTable table{n_x, n_y, {}};
  const std::size_t row = static_cast<std::size_t>(n_y) + 1;
  table.K.resize((static_cast<std::size_t>(n_x) + 1) * row);
  for (int d = 0; d <= n_x; ++d)
    fill_row(d * every_x, every_y, n_y + 1, hx, hy, table.K.data() + static_cast<std::size_t>(d) * row);
  return table;
}

double distributed_influence(int d_x, int d_y, double hx, double hy) {
  const int ax = std::abs(d_x), ay = std::abs(d_y);
  const double X = ax * hx, Y = ay * hy, distance = std::hypot(X, Y) / std::max(hx, hy);
  // One cell more than for K, since the nearest neighbour must be far enough as well.
  if (distance >= distance_for_4 + 1.0) return integrate_difference<4>(X, Y, hx, hy);
  if (distance >= distance_for_6 + 1.0) return integrate_difference<6>(X, Y, hx, hy);
  const double neighbours = influence(ax + 1, ay, hx, hy) + influence(ax - 1, ay, hx, hy) +
                            influence(ax, ay + 1, hx, hy) + influence(ax, ay - 1, hx, hy);
  return influence(ax, ay, hx, hy) - 0.25 * neighbours;
}

namespace {

// The mean of ln x over the cell at a distance of `far` cells, x in cells.
double mean_logarithm(int far) {
  if (far >= distance_for_6) {
    double sum = 0.0;
    using Rule = GaussRule<6>;
    for (std::size_t k = 0; k < Rule::node.size(); ++k) sum += Rule::weight[k] * std::log(far + Rule::node[k]);
    return sum;
  }
  const auto antiderivative = [](double x) { return x * std::log(x) - x; };
  return antiderivative(far + 0.5) - antiderivative(far - 0.5);
}

double line_influence_of(int far, double mean, double hx) {
  const double own = std::log(hx);
  return far == 0 ? hx * (1.0 + std::numbers::ln2 - own) : -hx * (mean + own);
}

/// The means of the cells 1, 2, .., which are stored because they are the same on all grids.
class Means {
 public:
  /// Means of the cells 0 (not used), every, .. n every.
  std::vector<double> at_most(int n, int every) {
    const std::lock_guard lock(mutex_);
    for (int far = static_cast<int>(known_.size()); far <= n * every; ++far)
      known_.push_back(far == 0 ? 0.0 : mean_logarithm(far));
    std::vector<double> means;
    for (int d = 0; d <= n; ++d) means.push_back(known_[static_cast<std::size_t>(d) * static_cast<std::size_t>(every)]);
    return means;
  }

 private:
  std::mutex mutex_;
  std::vector<double> known_;
};

}  // namespace

double line_influence(int d, double hx) {
  const int far = std::abs(d);
  return line_influence_of(far, far == 0 ? 0.0 : mean_logarithm(far), hx);
}

std::vector<double> line_influence_table(int n, double hx, int every) {
  static Means means;
  std::vector<double> table = means.at_most(n, every);
  for (int d = 0; d <= n; ++d) {
    double& value = table[static_cast<std::size_t>(d)];
    value = line_influence_of(d * every, value, hx);
  }
  return table;
}

double distributed_line_influence(int d, double hx) {
  return line_influence(d, hx) - 0.5 * (line_influence(d - 1, hx) + line_influence(d + 1, hx));
}

}  // namespace ehl::kernel
