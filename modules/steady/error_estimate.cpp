#include "steady/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ehl::steady {

ErrorEstimate estimate_error(std::span<const double> values, double scheme_order) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double lowest_order = 0.5;
  const std::size_t n = values.size();
  if (n < 2) return {nan, nan};
  const double last_change = values[n - 1] - values[n - 2];
  double observed = nan;
  if (n > 2) observed = std::log2((values[n - 2] - values[n - 3]) / last_change);
  double order = scheme_order - 0.5;
  if (n > 2) order = std::isfinite(observed) ? std::clamp(observed, lowest_order, scheme_order) : lowest_order;
  return {std::abs(last_change / (std::exp2(order) - 1.0) / values[n - 1]), observed};
}

}  // namespace ehl::steady
