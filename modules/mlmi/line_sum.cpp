#include "mlmi/line_sum.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/simd.hpp"

namespace ehl::mlmi {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

/// Vectors of sums that are kept in registers together; for a grid of 2^k cells the last block has one more.
constexpr int block = 8;

/// Largest number of points for which the exact sum is computed term by term: it takes no longer than a transform.
constexpr int most_direct = 65;

// C = K - P K on its patch. The sum of the dropped entries, separately of odd and of even distances, is added in the
// middle.
std::vector<double> correction_of(const Axis& axis, int order, int patch, const kernel::Kernel& kernel) {
  const int p = order / 2;
  const auto weights = midpoint_weights(order);
  const auto K = kernel::line_influence_table(kernel, patch + margin + 2 * p, axis.h, axis.every);
  const auto error = [&](int d) {
    double sum = K[at(std::abs(d))];
    for (int k = 1; k <= p; ++k)
      sum -= weights[at(k - 1)] * (K[at(std::abs(d - (2 * k - 1)))] + K[at(std::abs(d + (2 * k - 1)))]);
    return kernel.factor * sum;
  };
  std::vector<double> C;
  for (int d = -patch; d <= patch; ++d) C.push_back(error(d));
  for (int d = patch + 1; d <= patch + margin; ++d) {
    const double dropped = error(d);
    if (d % 2 == 0) {
      C[at(patch)] += 2.0 * dropped;
    } else {
      C[at(patch - 1)] += dropped;
      C[at(patch + 1)] += dropped;
    }
  }
  return C;
}

// Sums w_i for `vectors` vectors of points. in: K, a pointer to the kernel at the distance of the first of these points
// from point 0, readable for as many entries beyond the last distance; u at the points begin .. end - 1. The terms of
// each sum are added in the order of k.
template <int vectors>
void sum_block(const double* K, const double* u, std::size_t begin, std::size_t end, double* w) {
  core::Lanes sums[vectors] = {};
  for (std::size_t k = begin; k < end; ++k) {
    const core::Lanes pressure = core::broadcast(u[k]);
    for (int v = 0; v < vectors; ++v) sums[v] += core::load(K - k + v * core::lanes) * pressure;
  }
  for (int v = 0; v < vectors; ++v) core::store(w + v * core::lanes, sums[v]);
}

double value_at(const Axis& axis, const std::vector<double>& values, int i) {
  return i < axis.first || i > axis.last ? 0.0 : values[at(i - axis.first)];
}

}  // namespace

LineSum::LineSum(const Axis& axis, const MultilevelChoice& choice, const kernel::Kernel& kernel)
    : order_(choice.order), patch_(choice.patch_along) {
  Axis now = axis;
  const auto add = [&](std::vector<double> correction) {
    levels_.push_back(
        {now, std::vector<double>(at(now.points())), std::vector<double>(at(now.points())), std::move(correction)});
  };
  for (int l = 0; l < choice.coarsenings; ++l) {
    add(correction_of(now, order_, patch_, kernel));
    now = coarsened(now, order_);
  }
  add({});
  const int points = now.points();
  const std::vector<double> K = kernel::line_influence_table(kernel, points - 1, now.h, now.every);
  if (choice.coarsest_direct || points <= most_direct) {
    for (int d = 1 - points; d < points; ++d) kernel_.push_back(kernel.factor * K[at(std::abs(d))]);
    kernel_.resize(kernel_.size() + at((block + 1) * core::lanes));
    return;
  }
  std::vector<double> scaled(K.begin(), K.begin() + points);
  for (double& value : scaled) value *= kernel.factor;
  transformed_.emplace(scaled);
}

void LineSum::anterpolate(const Level& fine, Level& coarse) const {
  const auto weights = midpoint_weights(order_);
  for (int J = coarse.axis.first; J <= coarse.axis.last; ++J) {
    const auto u = [&](int i) { return value_at(fine.axis, fine.u, 2 * J + i); };
    double sum = u(0);
    for (int k = 1; k <= order_ / 2; ++k) sum += weights[at(k - 1)] * (u(1 - 2 * k) + u(2 * k - 1));
    coarse.u[at(J - coarse.axis.first)] = sum;
  }
}

void LineSum::interpolate(Level& coarse, Level& fine) const {
  const auto weights = midpoint_weights(order_);
  const auto corrected = [&](int i, int from, int step) {
    double sum = 0.0;
    for (int d = from; d <= patch_; d += step)
      sum += fine.correction[at(d + patch_)] * value_at(fine.axis, fine.u, i + d);
    return sum;
  };
  // Even points use the odd distances alone.
  for (int J = coarse.axis.first; J <= coarse.axis.last; ++J)
    coarse.w[at(J - coarse.axis.first)] += corrected(2 * J, -patch_ + (patch_ + 1) % 2, 2);
  for (int i = fine.axis.first; i <= fine.axis.last; ++i) {
    const int J = (i - (i & 1)) / 2;
    const auto w = [&](int K) { return coarse.w[at(K - coarse.axis.first)]; };
    double& sum = fine.w[at(i - fine.axis.first)];
    if (i == 2 * J) {
      sum = w(J);
      continue;
    }
    sum = corrected(i, -patch_, 1);
    for (int k = 1; k <= order_ / 2; ++k) sum += weights[at(k - 1)] * (w(J + 1 - k) + w(J + k));
  }
}

// Zero pressures at both ends of the line are skipped.
void LineSum::sum_directly(Level& level) const {
  const std::size_t points = level.u.size();
  std::size_t begin = 0, end = points;
  while (begin < end && level.u[begin] == 0.0) ++begin;
  while (end > begin && level.u[end - 1] == 0.0) --end;
  const double* K = &kernel_[points - 1];
  const double* u = level.u.data();
  constexpr std::size_t width = block * core::lanes;
  std::size_t i = 0;
  for (; i + width + core::lanes < points; i += width) sum_block<block>(K + i, u, begin, end, &level.w[i]);
  std::array<double, width + core::lanes> last;
  sum_block<block + 1>(K + i, u, begin, end, last.data());
  std::copy_n(last.begin(), points - i, &level.w[i]);
}

void LineSum::sum() {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) anterpolate(levels_[l], levels_[l + 1]);
  if (transformed_)
    transformed_->apply(levels_.back().u, levels_.back().w);
  else
    sum_directly(levels_.back());
  for (std::size_t l = levels_.size() - 1; l-- > 0;) interpolate(levels_[l + 1], levels_[l]);
}

std::size_t LineSum::bytes() const {
  std::size_t doubles = kernel_.size();
  for (const Level& level : levels_) doubles += 2 * level.u.size() + level.correction.size();
  return doubles * sizeof(double) + (transformed_ ? transformed_->bytes() : 0);
}

}  // namespace ehl::mlmi
