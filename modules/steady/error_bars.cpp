#include "steady/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/norms.hpp"
#include "judgement/error_estimate.hpp"
#include "judgement/fitted_minimum.hpp"
#include "rheology/laws.hpp"
#include "steady/domain_error.hpp"
#include "steady/layer_error.hpp"
#include "steady/observed_errors.hpp"
#include "steady/relief.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {
namespace {

Estimate extrapolated(const std::vector<double>& values, double order, double unsure, double algebraic) {
  const judgement::Extrapolation result = judgement::extrapolate(values, order, unsure);
  // An algebraic error of the last value enters the extrapolation with the factor 1 + 1/(2^p - 1).
  const double share = 1.0 + 1.0 / (std::exp2(order) - 1.0);
  return {result.value, result.relative_error + share * algebraic};
}

// Mesh size along X. Cells with the aspect ratio of the contact are as good as square cells of their width.
double step_in_shape(const Scene& scene, int nx) {
  const contact::Extent reach = contact::extent(scene.contact.shape);
  const double longer = std::clamp(reach.X / reach.Y, 1.0, core::stretch(scene.grid));
  return (scene.grid.X_b - scene.grid.X_a) / nx / longer;
}

// Mesh errors of a level; without an estimate from the grid sequence, a rough one from this level alone. The error of
// the nodal Hm includes its difference from the fitted minimum.
struct MeshError {
  double Hc;
  double Hm;
  double Hm_fitted;
};
MeshError mesh_error(const Scene& scene, const LevelRow& row, double order) {
  const double of_node = std::abs(row.Hm - row.Hm_fitted) / row.Hm;
  if (std::isfinite(row.mesh_error_Hc)) return {row.mesh_error_Hc, row.mesh_error_Hm, row.mesh_error_Hm - of_node};
  const judgement::Tuning& judged = scene.solver.judgement;
  const double step = step_in_shape(scene, row.nx);
  const double error = judgement::error_of_one_grid(judged, step, row.Hm_fitted, order);
  // Beside an ellipse the zone of the thinnest film is that of a circle's film of this thickness.
  const double error_Hm =
      judgement::error_of_one_grid(judged, step, row.Hm_fitted / scene.contact.edge_steepness, order);
  return {error, error_Hm + of_node, error_Hm};
}

// True if the differences fall or are rounding of the discrete solutions.
bool settles(const Tuning& tuning, const std::vector<double>& P) {
  const std::size_t n = P.size();
  const double before = std::abs(P[n - 2] - P[n - 3]);
  return std::abs(P[n - 1] - P[n - 2]) <= std::max(tuning.pressure_falls * before, tuning.pressure_at_rest * P[n - 1]);
}

/// A hidden spike: the pressure at the rim is below a share of the plateau, about as in the dry contact, but ln eta_bar
/// at the dry contact's rim pressure exceeds a limit, so that the oil makes a spike.
bool may_hide_spike(const Scene& scene, double P_max, double P_rim) {
  const Tuning& tuning = scene.tuning;
  return P_rim < tuning.rim_without_spike * P_max &&
         rheology::log_viscosity_at(scene.viscosity, tuning.dry_rim) > tuning.solid_at_rim;
}

void judge_P_max(const Scene& scene, const std::vector<double>& P_max, const std::vector<double>& P_rim,
                 ErrorBars& bars) {
  const std::size_t n = P_max.size();
  const Tuning& tuning = scene.tuning;
  const judgement::Tuning& judged = scene.solver.judgement;
  if (n < 3) {
    bars.spike_unresolved = n > 0 && (P_rim[n - 1] > tuning.rim_without_spike * P_max[n - 1] ||
                                      may_hide_spike(scene, P_max[n - 1], P_rim[n - 1]));
    return;
  }
  bars.spike_unresolved = true;
  bars.spike_unseen = may_hide_spike(scene, P_max[n - 1], P_rim[n - 1]);
  if (bars.spike_unseen) return;
  // A spike that has not settled grows with every grid.
  const double of_rim = settles(tuning, P_rim)
                            ? P_rim[n - 1] * judgement::estimate_error(judged, P_rim, 1.0).relative_error
                            : tuning.may_rise_by * std::abs(P_rim[n - 1] - P_rim[n - 2]);
  const bool overtakes = P_rim[n - 1] + of_rim > P_max[n - 1];
  bars.P_max_converging = settles(tuning, P_max) && (settles(tuning, P_rim) || !overtakes);
  bars.spike_unresolved = !bars.P_max_converging;
  if (!bars.P_max_converging) return;
  // A smooth maximum is of second order; its distance from the nearest node and a spike beside it lower that.
  bars.P_max = judgement::estimate_error(judged, P_max, tuning.order_of_P_max).relative_error;
  if (overtakes) bars.P_max = std::max(bars.P_max, (P_rim[n - 1] + of_rim) / P_max[n - 1] - 1.0);
}

/// Sum over all finer grids of a change that falls with order p from grid to grid.
double rest(double order) { return 1.0 / (std::exp2(order) - 1.0); }
const double of_second_order = rest(2.0);
const double of_wedge = rest(3.0);

/// The changes that the terms cause, each summed over all finer grids by its order.
double of_pressure_and_film(const adjoint::PredictedChange& parts) {
  return (std::abs(parts.poiseuille) + std::abs(parts.film)) * of_second_order;
}
double of_wedge_alone(const adjoint::PredictedChange& parts) { return std::abs(parts.wedge) * of_wedge; }
double disagreement(const adjoint::PredictedChange& parts, double seen) { return std::abs(parts.change() - seen); }

/// Remaining change by the grid sequence, with the wedge's part at its own order.
double correction(const adjoint::PredictedChange& parts, double seen) {
  return seen * of_second_order - parts.wedge * (of_second_order - of_wedge);
}

// The shares below are calibrated on contacts of many laws and shapes. [bench: share_of_terms]

/// Error of Hc: the correction by the grid sequence, and a share of the terms added as if they were independent.
double mesh_error_of_Hc(const Tuning& tuning, const adjoint::PredictedChange& parts, double seen) {
  return std::abs(correction(parts, seen)) + tuning.share_of_terms * std::hypot(parts.poiseuille * of_second_order,
                                                                                parts.film * of_second_order,
                                                                                parts.wedge * of_wedge);
}
/// Error of the fitted minimum: the sum of all terms without cancellation, because the minimum on the coarse grid of
/// the adjoint solution lies at a slightly different place; at least the correction by the grid sequence. A share of
/// the disagreement between the two is added.
double mesh_error_of_Hm(const Tuning& tuning, const adjoint::PredictedChange& parts, double seen) {
  return std::max(std::abs(correction(parts, seen)), of_pressure_and_film(parts) + of_wedge_alone(parts)) +
         tuning.share_of_disagreement * disagreement(parts, seen);
}

/// Algebraic error by the residual. A residual that changes its sign from node to node is seen by the coarse adjoint
/// solution only to a share of it.
double cycles_error_by_weights(const Tuning& tuning, const adjoint::PredictedChange& parts, double by_change) {
  return by_change + std::abs(parts.left) + tuning.share_of_scattered * std::abs(parts.scattered);
}

/// Error of the extrapolated Hc: the next order of the terms, by the mesh size over the zone in which the film forms,
/// and a share of the disagreement with the grid sequence.
Estimate Hc_by_weights(const Tuning& tuning, const adjoint::PredictedChange& parts, double value, double seen,
                       double step, double algebraic) {
  const double error = tuning.next_order * step * (of_pressure_and_film(parts) + of_wedge_alone(parts)) +
                       tuning.share_of_disagreement_extrapolated * disagreement(parts, seen);
  return {value * (1.0 + correction(parts, seen)), error + (1.0 + of_second_order) * algebraic};
}
/// Error of the extrapolated Hm: a share of the terms, and the disagreement with the grid sequence.
Estimate Hm_by_weights(const Tuning& tuning, const adjoint::PredictedChange& parts, double value, double seen,
                       double algebraic) {
  const double error = tuning.share_of_terms_extrapolated * (of_pressure_and_film(parts) + of_wedge_alone(parts)) +
                       disagreement(parts, seen) * of_second_order;
  return {value * (1.0 + correction(parts, seen)), error + (1.0 + of_second_order) * algebraic};
}

/// True if the last two changes of Hc have the same sign and decrease. At low loads the edge of rupture may turn the
/// sign; the extrapolated value is then worse than the nodal one, and only the grid sequence gives its error.
/// [bench: changes_fall]
bool changes_fall(const std::vector<LevelRow>& levels) {
  const std::size_t n = levels.size();
  if (n < 3) return false;
  const double change = levels[n - 1].Hc - levels[n - 2].Hc, before = levels[n - 2].Hc - levels[n - 3].Hc;
  return change * before > 0.0 && std::abs(change) < std::abs(before);
}

Estimate narrower(const Estimate& plain, const Estimate& extrapolated) {
  return extrapolated.error < plain.error ? extrapolated : plain;
}

void judge_by_adjoint(const Scene& scene, const adjoint::Errors& errors, const std::vector<LevelRow>& levels,
                      ErrorBars& bars) {
  const LevelRow& last = levels.back();
  const LevelRow& below = levels[levels.size() - 2];
  const Tuning& tuning = scene.tuning;
  const double seen_Hc = 1.0 - below.Hc / last.Hc;
  const double seen_Hm = 1.0 - below.Hm_fitted / last.Hm_fitted;
  const double of_node = std::abs(last.Hm - last.Hm_fitted) / last.Hm;
  bars.Hc = {mesh_error_of_Hc(tuning, errors.Hc, seen_Hc),
             cycles_error_by_weights(tuning, errors.Hc, bars.Hc.algebraic)};
  const double by_levels = bars.Hm_fitted.discretization;
  // The adjoint solution is that of a coarse grid; if its film is zero or negative, as beside slender contacts, the
  // adjoint estimate is far too large.
  bars.Hm_fitted = {std::min(mesh_error_of_Hm(tuning, errors.Hm, seen_Hm), tuning.most_of_levels * by_levels),
                    cycles_error_by_weights(tuning, errors.Hm, bars.Hm.algebraic)};
  bars.Hm = {bars.Hm_fitted.discretization + of_node, bars.Hm_fitted.algebraic};
  const double zone = std::pow(last.Hm_fitted / scene.contact.edge_steepness, 2.0 / 3.0);
  const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx / zone;
  if (changes_fall(levels))
    bars.Hc_extrapolated = Hc_by_weights(tuning, errors.Hc, last.Hc, seen_Hc, step, bars.Hc.algebraic);
  if (levels.size() > 2)
    bars.Hm_extrapolated = Hm_by_weights(tuning, errors.Hm, last.Hm_fitted, seen_Hm, bars.Hm_fitted.algebraic);
  bars.Hc_best = narrower({last.Hc, bars.Hc.total()}, bars.Hc_extrapolated);
  bars.Hm_best = narrower({last.Hm_fitted, bars.Hm_fitted.total()}, bars.Hm_extrapolated);
}

/// True for a line contact without supply or further effects, with the third-order wedge.
bool plain_line(const Scene& scene) {
  return scene.grid.line && !scene.supply && !scene.has_factors && reynolds::third_order(scene.wedge);
}

/// Line contacts: the grid sequence estimates better than the adjoint solution, whose cells are wider than a spike.
/// Hc converges with nearly the order of the wedge. Hm lies behind a spike that few meshes resolve, and is of first
/// order. [bench: line_bars]
void judge_line(const Scene& scene, const Solution& solution, ErrorBars& bars) {
  const LevelRow& last = solution.levels.back();
  const auto error = [&](double LevelRow::*value, double order) {
    return judgement::estimate_error(scene.solver.judgement, multigrid::column(solution.levels, value), order)
        .relative_error;
  };
  bars.Hc.discretization = error(&LevelRow::Hc, scene.tuning.order_of_Hc_of_line);
  bars.Hm_fitted.discretization = error(&LevelRow::Hm_fitted, scene.tuning.order_of_Hm_of_line);
  bars.Hm.discretization = bars.Hm_fitted.discretization + std::abs(last.Hm - last.Hm_fitted) / last.Hm;
  bars.Hc_best = {last.Hc, bars.Hc.total()};
  bars.Hm_best = {last.Hm_fitted, bars.Hm_fitted.total()};
}

double domain_error(const Scene& scene, const Solution& solution) {
  const bool ends_at_meniscus = scene.supply && !(solution.starvation && solution.starvation->filled > 0.0);
  if (ends_at_meniscus) return 0.0;
  if (solution.adjoint && scene.far_field && !plain_line(scene))
    return scene.tuning.safety_of_domain * std::max(solution.adjoint->Hc.domain, solution.adjoint->Hm.domain);
  if (std::isfinite(solution.domain_error_Hc)) return std::abs(solution.domain_error_Hc);
  return rough_domain_error(scene) * (plain_line(scene) && scene.far_field ? scene.tuning.safety_of_closed_line : 1.0);
}

}  // namespace

ErrorBars error_bars_of(const Scene& scene, const Solution& solution) {
  ErrorBars bars;
  if (solution.levels.empty()) return bars;
  const double order = reynolds::order(scene.wedge);
  const judgement::Tuning& judged = scene.solver.judgement;
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
  // Beside a meniscus the values have no fixed order, and for a line contact the extrapolation has no reliable error.
  if (!scene.supply && !plain_line(scene)) {
    bars.Hc_extrapolated = extrapolated(multigrid::column(solution.levels, &LevelRow::Hc), order, judged.unsure_of_Hc,
                                        checked.algebraic_error_Hc);
    bars.Hm_extrapolated = extrapolated(multigrid::column(solution.levels, &LevelRow::Hm_fitted), order,
                                        judged.unsure_of_Hm, checked.algebraic_error_Hm);
  }
  if (reynolds::third_order(scene.wedge) && std::isfinite(bars.Hm_extrapolated.error)) {
    const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx;
    const double least = judgement::third_order_floor(step, last.Hm_fitted, judged.third_order_floor_of_Hm);
    bars.Hm_extrapolated.error = std::max(least, bars.Hm_extrapolated.error);
  }
  bars.domain = domain_error(scene, solution);
  if (solution.levels.size() > 1) {
    if (plain_line(scene) && multigrid::column(solution.levels, &LevelRow::Hc).size() > 1)
      judge_line(scene, solution, bars);
    else if (!plain_line(scene) && solution.adjoint)
      judge_by_adjoint(scene, *solution.adjoint, solution.levels, bars);
  }
  judge_P_max(scene, multigrid::column(solution.levels, &LevelRow::P_max),
              multigrid::column(solution.levels, &LevelRow::P_rim), bars);
  add_errors_of_supply(scene.tuning, solution.passes, bars);
  leave_open_on_relief(scene, bars);
  bars.observed = errors_of_observed(scene, solution.levels, bars.spike_unresolved);
  return bars;
}

}  // namespace ehl::steady
