#include "thermal/lagged_source.hpp"

#include <algorithm>
#include <utility>

namespace ehl::thermal {
namespace {

constexpr double half = 0.5, most = 0.5;  // bounds of the ratio of two changes
constexpr double least_weight = 0.1;      // lower bound of w

}  // namespace

LaggedSource::LaggedSource(Source&& source, const core::Patch& patch)
    : source_(std::move(source)), left_(patch), left_before_(patch) {}

void LaggedSource::apply(const core::Field& q, core::Field& theta) {
  std::visit([&](auto& sum) { sum.apply(q, left_); }, source_);
  double size_before = 0.0, along = 0.0;  // squared norm of the previous change, and the present change projected on it
  for (int i = 0; i < left_.nodes_x(); ++i)
    for (int j = 0; j < left_.nodes_y(); ++j) {
      const double left = left_(i, j) - theta(i, j), before = left_before_(i, j);
      size_before += before * before;
      along += before * left;
    }
  const double share = along / size_before;  // amplification of one mode, 1 - w (1 + response of S)
  const bool known = size_before > 0.0 && (share < -half || weight_ < 1.0);
  if (known) weight_ = std::clamp(weight_ / (1.0 - std::min(share, most)), least_weight, 1.0);
  for (int i = 0; i < left_.nodes_x(); ++i)
    for (int j = 0; j < left_.nodes_y(); ++j) {
      const double left = left_(i, j) - theta(i, j);
      theta(i, j) = weight_ == 1.0 ? left_(i, j) : theta(i, j) + weight_ * left;
      left_(i, j) = left;
    }
  std::swap(left_, left_before_);
}

std::size_t LaggedSource::bytes() const {
  const auto nodes = static_cast<std::size_t>(left_.nodes_x()) * static_cast<std::size_t>(left_.nodes_y());
  return 2 * sizeof(double) * nodes + std::visit([](const auto& sum) { return sum.bytes(); }, source_);
}

}  // namespace ehl::thermal
