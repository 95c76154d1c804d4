#include "steady/observed_errors.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "judgement/error_estimate.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {
namespace {

// There is no estimate if changes grow from level to level.
bool grows(const Tuning& tuning, const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 3) return false;
  const double change = std::abs(values[n - 1] - values[n - 2]), before = std::abs(values[n - 2] - values[n - 3]);
  return change > tuning.growing_change * before && change > tuning.small_change * std::abs(values[n - 1]);
}

// The part of an integral from below a spike converges slowly because the grids only begin to resolve the spike. The
// least error is for the remaining iteration error; that of two levels for errors that cancel by chance.
double error_of(const Scene& scene, const std::vector<double>& values, bool spike_unresolved) {
  const Tuning& tuning = scene.tuning;
  const judgement::Tuning& judged = scene.solver.judgement;
  if (std::ranges::all_of(values, [](double value) { return value == 0.0; })) return 0.0;
  if (grows(tuning, values)) return core::unknown;
  if (values.size() < 3)
    return judgement::estimate_error(judged, values,
                                     spike_unresolved ? tuning.slowest_order_of_observed : tuning.order_of_two_levels,
                                     tuning.least_of_two_levels)
        .relative_error;
  return judgement::estimate_error(judged, values, tuning.order_of_observed, tuning.least_observed,
                                   tuning.slowest_order_of_observed)
      .relative_error;
}

}  // namespace

std::vector<double> errors_of_observed(const Scene& scene, const std::vector<multigrid::LevelRow>& levels,
                                       bool spike_unresolved) {
  std::vector<double> errors;
  if (levels.empty()) return errors;
  for (std::size_t k = 0; k < levels.back().observed.size(); ++k)
    errors.push_back(error_of(scene, multigrid::column_observed(levels, k), spike_unresolved));
  return errors;
}

}  // namespace ehl::steady
