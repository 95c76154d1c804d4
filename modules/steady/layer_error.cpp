#include "steady/layer_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "judgement/error_estimate.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {
namespace {

double derivative(double least_difference, const std::vector<Pass>& passes, double Pass::*film) {
  constexpr double in_proportion = 1.0;
  const Pass& last = passes.back();
  for (std::size_t k = passes.size() - 1; k-- > 0;) {
    const Pass& before = passes[k];
    const double supply = std::log(before.supply / last.supply);
    if (std::abs(supply) < least_difference) continue;
    const double slope = std::abs(std::log(before.*film / last.*film) / supply);
    return std::isfinite(slope) ? slope : in_proportion;
  }
  return in_proportion;
}

}  // namespace

void judge_layers(const Scene& scene, const std::vector<double>& coarse, std::vector<Pass>& passes) {
  double error = 0.0;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    if (k >= coarse.size()) {
      passes[k].supply_error = core::unknown;
      continue;
    }
    const double both[] = {coarse[k], passes[k].supply};
    if (k > 0)
      error = std::max(
          error, judgement::estimate_error(scene.solver.judgement, both, scene.tuning.order_of_supply).relative_error);
    passes[k].supply_error = error;
  }
}

SupplyErrors errors_of_supply(const Tuning& tuning, const std::vector<Pass>& passes) {
  const double error = passes.back().supply_error;
  const double least = tuning.least_supply_difference;
  return {error * derivative(least, passes, &Pass::Hc), error * derivative(least, passes, &Pass::Hm)};
}

void add_errors_of_supply(const Tuning& tuning, const std::vector<Pass>& passes, ErrorBars& bars) {
  if (passes.size() < 2) return;
  const SupplyErrors errors = errors_of_supply(tuning, passes);
  bars.Hc.discretization += errors.Hc;
  bars.Hm.discretization += errors.Hm;
  bars.Hm_fitted.discretization += errors.Hm;
  for (Estimate* one : {&bars.Hc_extrapolated, &bars.Hc_best}) one->error += errors.Hc;
  for (Estimate* one : {&bars.Hm_extrapolated, &bars.Hm_best}) one->error += errors.Hm;
}

}  // namespace ehl::steady
