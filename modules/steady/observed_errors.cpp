#include "steady/observed_errors.hpp"

#include <algorithm>
#include <cmath>

#include "judgement/error_estimate.hpp"

namespace ehl::steady {
namespace {

/// Assumed order of an integral over the film, and the lowest order that is believed. The part from below a spike
/// converges slowly because the grids only begin to resolve the spike. [bench: slowest_order_of_observed]
constexpr double order = 1.5, slowest_order = 0.32;
/// Order assumed with two levels; slowest_order if a spike may be unresolved.
constexpr double order_of_two_levels = 1.0;
/// Lower bound of the error, for the remaining iteration error; of two levels for errors that cancel by chance.
constexpr double least = 3e-4, least_of_two_levels = 2e-3;
/// There is no estimate if changes grow from level to level by more than this factor, unless they are smaller than this
/// share of the number.
constexpr double growing = 1.1, small_change = 1e-3;

bool grows(const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 3) return false;
  const double change = std::abs(values[n - 1] - values[n - 2]), before = std::abs(values[n - 2] - values[n - 3]);
  return change > growing * before && change > small_change * std::abs(values[n - 1]);
}

double error_of(const std::vector<double>& values, bool spike_unresolved) {
  if (std::ranges::all_of(values, [](double value) { return value == 0.0; })) return 0.0;
  if (grows(values)) return ErrorBar::unknown;
  if (values.size() < 3)
    return judgement::estimate_error(values, spike_unresolved ? slowest_order : order_of_two_levels,
                                     least_of_two_levels)
        .relative_error;
  return judgement::estimate_error(values, order, least, slowest_order).relative_error;
}

}  // namespace

std::vector<double> errors_of_observed(const std::vector<multigrid::LevelRow>& levels, bool spike_unresolved) {
  std::vector<double> errors;
  if (levels.empty()) return errors;
  for (std::size_t k = 0; k < levels.back().observed.size(); ++k)
    errors.push_back(error_of(multigrid::column_observed(levels, k), spike_unresolved));
  return errors;
}

}  // namespace ehl::steady
