#include "steady/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/norms.hpp"
#include "judgement/error_estimate.hpp"
#include "judgement/fitted_minimum.hpp"
#include "rheology/laws.hpp"
#include "steady/domain_error.hpp"
#include "steady/layer_error.hpp"
#include "steady/relief.hpp"
#include "steady/resolution.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {
namespace {

/// Differences of P_max that fall by less than this from level to level do not converge as a smooth pressure's do.
constexpr double falls = 0.7;
/// Changes of P_max below this are rounding of the discrete solutions themselves.
constexpr double at_rest = 1e-5;

Estimate extrapolated(const std::vector<double>& values, double order, double unsure, double algebraic) {
  const judgement::Extrapolation result = judgement::extrapolate(values, order, unsure);
  // An algebraic error of the last value enters the extrapolation with 1 + 1/(2^p - 1).
  const double share = 1.0 + 1.0 / (std::exp2(order) - 1.0);
  return {result.value, result.relative_error + share * algebraic};
}

// Mesh size along X. Cells as much longer than wide as the contact itself are as good as square ones of their width.
double step_in_shape(const Scene& scene, int nx) {
  const contact::Extent reach = contact::extent(scene.shape);
  const double longer = std::clamp(reach.X / reach.Y, 1.0, core::stretch(scene.grid));
  return (scene.grid.X_b - scene.grid.X_a) / nx / longer;
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
  const double step = step_in_shape(scene, row.nx);
  const double error = judgement::error_of_one_grid(step, row.Hm_fitted, order);
  // Beside an ellipse the zone in which the film is thinnest is that of a circle's film of this height.
  const double error_Hm = judgement::error_of_one_grid(step, row.Hm_fitted / edge_steepness(scene.shape), order);
  return {error, error_Hm + of_node, error_Hm};
}

// A spike that has not settled grows with every grid, at (71, 13) on Barus' oil from 0.77 on 256 cells to 1.27 on 1024:
// it may overtake the plateau within so many times what it rose by last.
constexpr double may_rise_by = 4.0;

bool settles(const std::vector<double>& P) {
  const std::size_t n = P.size();
  const double before = std::abs(P[n - 2] - P[n - 3]);
  return std::abs(P[n - 1] - P[n - 2]) <= std::max(falls * before, at_rest * P[n - 1]);
}

/// A smooth maximum is of second order; its node's distance from it, and what a spike beside it does, are not.
/// measured: of order 2 nearly half of the bars on 256 cells are too small, of order 1 they are 12 times too wide in
/// the median.
constexpr double order_of_P_max = 1.5;

/// A spike that the mesh does not show yet, where the oil would make one: the rim then has the dry contact's 0.8 of the
/// plateau and little more. measured, 99 bars on 256 and 512 cells: the six that were wrong by 3 to 28 % are of such
/// contacts, with ln eta_bar above 12.8; below 12.5 finer grids showed spikes that were lower than the plateau.
constexpr double rim_without_spike = 0.85, solid_at_rim = 12.0, dry_rim = 0.8;

bool may_hide_spike(const rheology::ViscosityLaw& viscosity, double P_max, double P_rim) {
  return P_rim < rim_without_spike * P_max && rheology::log_viscosity_at(viscosity, dry_rim) > solid_at_rim;
}

void judge_P_max(const Scene& scene, const std::vector<double>& P_max, const std::vector<double>& P_rim,
                 ErrorBars& bars) {
  const std::size_t n = P_max.size();
  if (n < 3) {
    bars.spike_unresolved = n > 0 && (P_rim[n - 1] > rim_without_spike * P_max[n - 1] ||
                                      may_hide_spike(scene.viscosity, P_max[n - 1], P_rim[n - 1]));
    return;
  }
  bars.spike_unresolved = true;
  bars.spike_unseen = may_hide_spike(scene.viscosity, P_max[n - 1], P_rim[n - 1]);
  if (bars.spike_unseen) return;
  const double of_rim = settles(P_rim) ? P_rim[n - 1] * judgement::estimate_error(P_rim, 1.0).relative_error
                                       : may_rise_by * std::abs(P_rim[n - 1] - P_rim[n - 2]);
  const bool overtakes = P_rim[n - 1] + of_rim > P_max[n - 1];
  bars.P_max_converging = settles(P_max) && (settles(P_rim) || !overtakes);
  bars.spike_unresolved = !bars.P_max_converging;
  if (!bars.P_max_converging) return;
  bars.P_max = judgement::estimate_error(P_max, order_of_P_max).relative_error;
  if (overtakes) bars.P_max = std::max(bars.P_max, (P_rim[n - 1] + of_rim) / P_max[n - 1] - 1.0);
}

/// A sum over all grids that are still finer, of what falls with the order p from grid to grid.
double rest(double order) { return 1.0 / (std::exp2(order) - 1.0); }
const double of_second_order = rest(2.0);
const double of_wedge = rest(3.0);

/// What the terms leave, each summed up over all finer grids by its order.
double of_pressure_and_film(const adjoint::Foretold& parts) {
  return (std::abs(parts.poiseuille) + std::abs(parts.film)) * of_second_order;
}
double of_wedge_alone(const adjoint::Foretold& parts) { return std::abs(parts.wedge) * of_wedge; }
double disagreement(const adjoint::Foretold& parts, double seen) { return std::abs(parts.change() - seen); }

/// What the levels say, the wedge's part by its own order.
double correction(const adjoint::Foretold& parts, double seen) {
  return seen * of_second_order - parts.wedge * (of_second_order - of_wedge);
}

// calibrated: 114 contacts (24 listed, 90 drawn: laws, ellipses), 128 to 512 cells, 283 values of each
// (bench_coverage): of Hc 275 within, 2.0 times too wide in the median, of Hm 273, 2.9.

/// Of Hc: what the levels say, and a share of the terms as if they knew nothing of each other.
constexpr double share_of_terms = 0.55;
double mesh_error_of_Hc(const adjoint::Foretold& parts, double seen) {
  return std::abs(correction(parts, seen)) + share_of_terms * std::hypot(parts.poiseuille * of_second_order,
                                                                         parts.film * of_second_order,
                                                                         parts.wedge * of_wedge);
}
/// Of the fitted minimum: all terms whatever their signs, for its place on the weights' coarse grid is not quite that
/// of the minimum, and a share of what the levels say against them; no less than what the levels say.
constexpr double share_of_disagreement = 0.25;
double mesh_error_of_Hm(const adjoint::Foretold& parts, double seen) {
  return std::max(std::abs(correction(parts, seen)), of_pressure_and_film(parts) + of_wedge_alone(parts)) +
         share_of_disagreement * disagreement(parts, seen);
}

/// What the cycles leave, by the residual: no sum of weights of a coarse grid sees what of it changes its sign from
/// node to node better than to a tenth. measured: 90 of 92 values within, 3.7 times too wide in the median, and 0.03 of
/// the mesh's bar; by the last cycle's change alone 58.
constexpr double share_of_scattered = 0.1;
double cycles_error_by_weights(const adjoint::Foretold& parts, double by_change) {
  return by_change + std::abs(parts.left) + share_of_scattered * std::abs(parts.scattered);
}

/// Unsure of Hc: the next order of what the terms leave, by the step over the zones in which the film is made; and a
/// share of what the levels say against the weights. calibrated: as above, on 256 cells: 72 of 76 within, 3.1 times.
constexpr double next_order = 2.0, share_of_disagreement_extrapolated = 0.17;
Estimate Hc_by_weights(const adjoint::Foretold& parts, double value, double seen, double step, double algebraic) {
  const double error = next_order * step * (of_pressure_and_film(parts) + of_wedge_alone(parts)) +
                       share_of_disagreement_extrapolated * disagreement(parts, seen);
  return {value * (1.0 + correction(parts, seen)), error + (1.0 + of_second_order) * algebraic};
}
/// Of Hm: a share of the terms, and what the levels say against them. Likewise: 75 of 79, 3.3 times. (A bar that just
/// holds 95 % of normally distributed errors is 2.9 times the median one.)
constexpr double share_of_terms_extrapolated = 0.6;
Estimate Hm_by_weights(const adjoint::Foretold& parts, double value, double seen, double algebraic) {
  const double error = share_of_terms_extrapolated * (of_pressure_and_film(parts) + of_wedge_alone(parts)) +
                       disagreement(parts, seen) * of_second_order;
  return {value * (1.0 + correction(parts, seen)), error + (1.0 + of_second_order) * algebraic};
}

/// Of a light contact the error is made where the pressure ruptures, which is no wider however thick the film.
constexpr double widest_zone = 0.5;
/// With the same sign. At M = 2 to 5 the edge of rupture, a cell off here or there, may turn it: the extrapolated value
/// is then further off than the plain one, by ten times its bar, and the levels alone tell its error.
bool changes_fall(const std::vector<LevelRow>& levels) {
  const std::size_t n = levels.size();
  if (n < 3) return false;
  const double change = levels[n - 1].Hc - levels[n - 2].Hc, before = levels[n - 2].Hc - levels[n - 3].Hc;
  return change * before > 0.0 && std::abs(change) < std::abs(before);
}

/// The weights are those of a coarse grid. Where its film is zero and less they tell much too much: beside slender
/// contacts 29 to 240 times the change to the finer grid, where the levels tell 1.2 to 3 times. measured: with and
/// without this all 79 drawn bars of Hm hold (bench_coverage), and 22 of 22 of slender ones (elliptic_slender.py
/// drawn).
constexpr double most_of_levels = 3.0;

Estimate narrower(const Estimate& plain, const Estimate& extrapolated) {
  return extrapolated.error < plain.error ? extrapolated : plain;
}

void judge_by_weights(const Scene& scene, const adjoint::Errors& errors, const std::vector<LevelRow>& levels,
                      ErrorBars& bars) {
  const LevelRow& last = levels.back();
  const LevelRow& below = levels[levels.size() - 2];
  const double seen_Hc = 1.0 - below.Hc / last.Hc;
  const double seen_Hm = 1.0 - below.Hm_fitted / last.Hm_fitted;
  const double of_node = std::abs(last.Hm - last.Hm_fitted) / last.Hm;
  bars.Hc = {mesh_error_of_Hc(errors.Hc, seen_Hc), cycles_error_by_weights(errors.Hc, bars.Hc.algebraic)};
  const double by_levels = bars.Hm_fitted.discretization;
  bars.Hm_fitted = {std::min(mesh_error_of_Hm(errors.Hm, seen_Hm), most_of_levels * by_levels),
                    cycles_error_by_weights(errors.Hm, bars.Hm.algebraic)};
  bars.Hm = {bars.Hm_fitted.discretization + of_node, bars.Hm_fitted.algebraic};
  const double zone = std::min(widest_zone, std::pow(last.Hm_fitted / edge_steepness(scene.shape), 2.0 / 3.0));
  const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx / zone;
  if (changes_fall(levels)) bars.Hc_extrapolated = Hc_by_weights(errors.Hc, last.Hc, seen_Hc, step, bars.Hc.algebraic);
  if (levels.size() > 2)
    bars.Hm_extrapolated = Hm_by_weights(errors.Hm, last.Hm_fitted, seen_Hm, bars.Hm_fitted.algebraic);
  bars.Hc_best = narrower({last.Hc, bars.Hc.total()}, bars.Hc_extrapolated);
  bars.Hm_best = narrower({last.Hm_fitted, bars.Hm_fitted.total()}, bars.Hm_extrapolated);
}

/// A line contact without what makes its errors others: a meniscus, heat, another scheme.
bool plain_line(const Scene& scene) {
  return scene.grid.line && !scene.supply && scene.effects.empty() && reynolds::third_order(scene.wedge);
}

/// Of a line contact the levels tell more than the weights, whose cells are wider than a spike: extrapolated by them Hm
/// was further off in the median than it was on the mesh (0.25 % for 0.07 % on 1024 cells), and 61 of 390 bars were too
/// narrow. By the levels, each taken for less than the scheme's order, 15 of 1440 bars of Hc and Hm: 180 lines, M = 2
/// to 900, L = 0 to 23, 128 to 1024 cells against 8192; 5 to 6 times too wide in the median. A film may swing back, Hm
/// beside a spike and Hc where changes of opposite sign meet: no error is less than a share of the one a level below,
/// that of the order from level to level, but for a factor of 3. (Without it 25 of 720 bars of Hc.)
constexpr double order_of_Hc_of_line = 1.5, least_share_of_Hc = 0.25;
constexpr double order_of_Hm_of_line = 1.0, least_share_of_Hm = 0.5;
constexpr double floor_of_Hm_of_line = 0.03;

double error_of_levels(std::span<const double> values, double order, double least_share, double floor) {
  const double error = judgement::estimate_error(values, order).relative_error;
  const double before = judgement::estimate_error(values.first(values.size() - 1), order).relative_error;
  const double swung_back = std::isfinite(before) ? std::min(least_share * before, 3.0 * error) : 0.0;
  return std::max({error, swung_back, floor});
}

void judge_line(const Scene& scene, const Solution& solution, ErrorBars& bars) {
  const LevelRow& last = solution.levels.back();
  const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx;
  const auto floor = [&](double share) { return judgement::third_order_floor(step, last.Hm_fitted, share); };
  bars.Hc.discretization = error_of_levels(fmg::column(solution.levels, &LevelRow::Hc), order_of_Hc_of_line,
                                           least_share_of_Hc, floor(judgement::third_order_floor_of_Hc));
  bars.Hm_fitted.discretization = error_of_levels(fmg::column(solution.levels, &LevelRow::Hm_fitted),
                                                  order_of_Hm_of_line, least_share_of_Hm, floor(floor_of_Hm_of_line));
  bars.Hm.discretization = bars.Hm_fitted.discretization + std::abs(last.Hm - last.Hm_fitted) / last.Hm;
  bars.Hc_best = {last.Hc, bars.Hc.total()};
  bars.Hm_best = {last.Hm_fitted, bars.Hm_fitted.total()};
}

/// measured: 29 contacts, half of them ellipses at any angle, on the chosen domain and one smaller by a fifth, against
/// domains of twice the size: 61 of 61 within, 4.4 times too wide in the median, 23 at most.
constexpr double safety_of_domain = 5.0;
/// Of a line's closed domain, over the rough estimate. measured: M = 1 to 200, L = 0 to 25, against twice the length.
constexpr double safety_of_closed_line = 3.0;

double domain_error(const Scene& scene, const Solution& solution) {
  const bool ends_at_meniscus = scene.supply && !(solution.starvation && solution.starvation->filled > 0.0);
  if (ends_at_meniscus) return 0.0;
  if (solution.adjoint && scene.far_field && !plain_line(scene))
    return safety_of_domain * std::max(solution.adjoint->Hc.domain, solution.adjoint->Hm.domain);
  if (std::isfinite(solution.domain_error_Hc)) return std::abs(solution.domain_error_Hc);
  return rough_domain_error(scene) * (plain_line(scene) && scene.far_field ? safety_of_closed_line : 1.0);
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
  // Beside a meniscus no order holds from level to level, and of a line no extrapolation's error does.
  if (!scene.supply && !plain_line(scene)) {
    bars.Hc_extrapolated = extrapolated(fmg::column(solution.levels, &LevelRow::Hc), order, judgement::unsure_of_Hc,
                                        checked.algebraic_error_Hc);
    bars.Hm_extrapolated = extrapolated(fmg::column(solution.levels, &LevelRow::Hm_fitted), order,
                                        judgement::unsure_of_Hm, checked.algebraic_error_Hm);
  }
  if (reynolds::third_order(scene.wedge) && std::isfinite(bars.Hm_extrapolated.error)) {
    const double step = (scene.grid.X_b - scene.grid.X_a) / last.nx;
    const double least = judgement::third_order_floor(step, last.Hm_fitted, judgement::third_order_floor_of_Hm);
    bars.Hm_extrapolated.error = std::max(least, bars.Hm_extrapolated.error);
  }
  bars.domain = domain_error(scene, solution);
  if (solution.levels.size() > 1) {
    if (plain_line(scene) && fmg::column(solution.levels, &LevelRow::Hc).size() > 1)
      judge_line(scene, solution, bars);
    else if (!plain_line(scene) && solution.adjoint)
      judge_by_weights(scene, *solution.adjoint, solution.levels, bars);
  }
  judge_P_max(scene, fmg::column(solution.levels, &LevelRow::P_max), fmg::column(solution.levels, &LevelRow::P_rim),
              bars);
  add_errors_of_supply(solution.passes, bars);
  leave_open_on_relief(scene, bars);
  return bars;
}

}  // namespace ehl::steady
