#include "steady/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/norms.hpp"
#include "judgement/error_estimate.hpp"
#include "judgement/fitted_minimum.hpp"
#include "steady/domain_error.hpp"
#include "steady/resolution.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {
namespace {

/// Differences of P_max that fall by less than this from level to level do not converge as a smooth pressure's do.
constexpr double falls = 0.7;
/// Changes of P_max below this are rounding of the discrete solutions themselves.
constexpr double at_rest = 1e-5;

std::vector<double> column(const Solution& solution, double LevelRow::*value) {
  std::vector<double> values;
  for (const LevelRow& row : solution.levels) values.push_back(row.*value);
  return values;
}

Extrapolated extrapolated(const std::vector<double>& values, double order, double unsure, double algebraic) {
  const judgement::Extrapolation result = judgement::extrapolate(values, order, unsure);
  // An algebraic error of the last value enters the extrapolation with 1 + 1/(2^p - 1).
  const double share = 1.0 + 1.0 / (std::exp2(order) - 1.0);
  return {result.value, result.relative_error + share * algebraic};
}

// Of the mesh; where a row has no estimate of it, from that row alone. The node's distance from the minimum counts.
struct MeshError {
  double Hc;
  double Hm;
  double Hm_fitted;
};
MeshError mesh_error(const Scene& scene, const LevelRow& row, double order) {
  const double of_node = std::abs(row.Hm - row.Hm_fitted) / row.Hm;
  if (std::isfinite(row.error_Hc)) return {row.error_Hc, row.error_Hm, row.error_Hm - of_node};
  const double step = (scene.grid.X_b - scene.grid.X_a) / row.nx;
  const double error = judgement::error_of_one_grid(step, row.Hm_fitted, order);
  // Beside an ellipse the zone in which the film is thinnest is that of a circle's film of this height.
  const double error_Hm = judgement::error_of_one_grid(step, row.Hm_fitted / edge_steepness(scene.shape), order);
  return {error, error_Hm + of_node, error_Hm};
}

void judge_P_max(const std::vector<double>& P_max, ErrorBars& bars) {
  const std::size_t n = P_max.size();
  if (n < 3) return;
  const double before = std::abs(P_max[n - 2] - P_max[n - 3]);
  const double last = std::abs(P_max[n - 1] - P_max[n - 2]);
  bars.P_max_converging = last <= std::max(falls * before, at_rest * P_max[n - 1]);
  if (bars.P_max_converging) bars.P_max = judgement::estimate_error(P_max, 1.0).relative_error;
}

}  // namespace

ErrorBars error_bars_of(const Scene& scene, const Solution& solution) {
  ErrorBars bars;
  if (solution.levels.empty()) return bars;
  const double order = reynolds::order(scene.wedge);
  const LevelRow& last = solution.levels.back();
  const Verification& checked = solution.verification;
  const MeshError mesh = mesh_error(scene, last, order);
  bars.Hc = {mesh.Hc, checked.algebraic_error_Hc};
  bars.Hm = {mesh.Hm, checked.algebraic_error_Hm};
  bars.Hm_fitted = {mesh.Hm_fitted, checked.algebraic_error_Hm};
  bars.Hm_fitted_value = last.Hm_fitted;
  if (solution.H.nodes_x() > 0) {
    const core::Location node = core::minimum(solution.H);
    const judgement::FittedMinimum fitted = judgement::fitted_minimum(solution.grid, solution.H, node.i, node.j);
    bars.Hm_fitted_X = fitted.X;
    bars.Hm_fitted_Y = fitted.Y;
  }
  bars.Hc_extrapolated =
      extrapolated(column(solution, &LevelRow::Hc), order, judgement::unsure_of_Hc, checked.algebraic_error_Hc);
  bars.Hm_extrapolated =
      extrapolated(column(solution, &LevelRow::Hm_fitted), order, judgement::unsure_of_Hm, checked.algebraic_error_Hm);
  if (reynolds::third_order(scene.wedge) && std::isfinite(bars.Hm_extrapolated.error)) {
    const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx;
    const double least = judgement::third_order_floor(step, last.Hm_fitted, judgement::third_order_floor_of_Hm);
    bars.Hm_extrapolated.error = std::max(least, bars.Hm_extrapolated.error);
  }
  bars.domain =
      std::isfinite(solution.domain_error_Hc) ? std::abs(solution.domain_error_Hc) : rough_domain_error(scene);
  judge_P_max(column(solution, &LevelRow::P_max), bars);
  return bars;
}

}  // namespace ehl::steady
