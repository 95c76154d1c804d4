#include "steady/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "multigrid/start.hpp"
#include "steady/larger_domain.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/warnings.hpp"

namespace ehl::steady {
namespace {

/// Step factor of the search for the size of the domain.
constexpr double step_of_size = 1.01;

std::string percent(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g %%", 100.0 * value);
  return buffer;
}

std::string gigabytes(double bytes) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g GB", 1e-9 * bytes);
  return buffer;
}

// The scene on a coarse mesh, to be solved to a small residual: only Hc and the fitted minimum are needed.
Scene coarse_scene(const Scene& scene, const core::Grid& grid) {
  Scene coarse = scene;
  coarse.grid = grid;
  coarse.deformation = mlmi::fitting(coarse.deformation, grid);
  coarse.accuracy = {};
  coarse.adjoint_errors = false;
  coarse.solver.tolerance = scene.solver.judgement.default_tolerance;
  return coarse;
}

// Error of a domain, relative to the film: `inlet` falls with the third power of the size, `load` with the first
// (domain_error.hpp). `square` is a lower bound that falls with the second power, fitted to the first doubling alone.
struct DomainError {
  double square = 0.0;
  double inlet = 0.0;
  double load = 0.0;
  double left(double size) const {
    return std::max(square / (size * size), inlet / (size * size * size) + load / size);
  }
};

// Error from the changes of the film when the domain is doubled once and twice; if the second change is unknown, from
// `square` alone.
DomainError domain_error(double gain, double next_gain) {
  const double square = 4.0 / 3.0 * gain;
  if (std::isnan(next_gain)) return {square, 0.0, 0.0};
  // gain = 7/8 inlet + 1/2 load, next_gain = 7/64 inlet + 1/4 load.
  const double load = std::clamp((8.0 * next_gain - gain) / 1.5, 0.0, 2.0 * gain);
  return {square, 8.0 / 7.0 * (gain - 0.5 * load), load};
}

double change(const LevelRow& from, const LevelRow& to, double LevelRow::*film) {
  return std::abs(to.*film / from.*film - 1.0);
}
double gain_of_Hc(const LevelRow& from, const LevelRow& to) { return change(from, to, &LevelRow::Hc); }
// The nodes are the same on both domains. If the minimum moves to another node, either the nodal or the fitted value
// jumps, so the smaller change counts.
double gain_of_Hm(const LevelRow& from, const LevelRow& to) {
  return std::min(change(from, to, &LevelRow::Hm), change(from, to, &LevelRow::Hm_fitted));
}

std::vector<Scene> series_from(const Scene& scene, core::Grid grid) {
  std::vector<Scene> series;
  for (int size = 1; size <= 4; size *= 2, grid = doubled(grid, sides_of(scene))) {
    if (size == 4 && grid.nx > scene.tuning.most_coarse_cells) break;
    series.push_back(coarse_scene(scene, grid));
  }
  return series;
}

// The larger of the errors of Hc and Hm; NaN if a solution fails.
DomainError domain_error(const std::vector<Scene>& series, const SolveOnGrid& solve_on_grid) {
  std::vector<LevelRow> rows;
  for (const Scene& coarse : series) {
    const Solution solution = solve_on_grid(coarse);
    if (!solution.converged) return {std::nan(""), 0.0, 0.0};
    rows.push_back(solution.levels.back());
  }
  const auto error_of = [&](const auto& gain) {
    return domain_error(gain(rows[0], rows[1]), rows.size() > 2 ? gain(rows[1], rows[2]) : std::nan(""));
  };
  const DomainError Hc = error_of(gain_of_Hc);
  const DomainError Hm = error_of(gain_of_Hm);
  return {std::max(Hc.square, Hm.square), std::max(Hc.inlet, Hm.inlet), std::max(Hc.load, Hm.load)};
}

// Estimated on half as many cells; on the cells of the scene if the coarser mesh has no solution, as at the ends of a
// roller.
DomainError domain_error(const Scene& scene, const SolveOnGrid& solve_on_grid) {
  const DomainError coarse = domain_error(domain_series(scene), solve_on_grid);
  return std::isnan(coarse.square) ? domain_error(series_from(scene, scene.grid), solve_on_grid) : coarse;
}

// Continues full multigrid from the solution on a coarser grid to the grid of `finer`.
Solution refined(const Scene& finer, const Solution& coarser, const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(finer, {}, progress);
  std::size_t l = 0;
  while (l < run.finest() && run.hierarchy.levels[l].grid.nx < coarser.grid.nx) ++l;
  run.record.levels = coarser.levels;
  run.record.history = coarser.history;
  run.plan.first = l;
  multigrid::start_from_state(run.hierarchy, l, {core::on_patch(run.hierarchy.levels[l].grid, coarser.P), coarser.H00});
  multigrid::for_levels(run, l + 1, run.hierarchy.levels.size(), multigrid::start_from_below, multigrid::solve_level);
  Solution solution = end_multigrid(finer, std::move(run));
  solution.method = coarser.method;
  solution.path = coarser.path;
  solution.attempts = coarser.attempts;
  solution.continuation = coarser.continuation;
  solution.error_bars = error_bars_of(finer, solution);
  return solution;
}

double worst(double Hc, double Hm) { return std::isnan(Hc + Hm) ? std::nan("") : std::max(Hc, Hm); }
double plain_error(const ErrorBars& bars) { return worst(bars.Hc.total(), bars.Hm.total()); }
// Error of the values that are reported first.
double best_error(const ErrorBars& bars) {
  const double best = worst(bars.Hc_best.error, bars.Hm_best.error);
  return std::isnan(best) ? plain_error(bars) : best;
}
double extrapolated_error(const ErrorBars& bars) {
  return worst(bars.Hc_extrapolated.error, bars.Hm_extrapolated.error);
}

// Predicted number of cells for the values that are reported first, by the order of the scheme; at least the next
// level, also if the error is unknown.
double predicted_cells(const Scene& scene, const Solution& solution, double allowed) {
  double error = best_error(solution.error_bars);
  double cells = solution.grid.nx;
  do {
    cells *= 2.0;
    error /= std::exp2(reynolds::order(scene.wedge));
  } while (error > scene.tuning.predicted_share * allowed);
  return cells;
}

// The limit that a grid exceeds; empty if none.
std::string forbidden(const Scene& scene, const core::Grid& grid) {
  if (grid.nx > scene.accuracy.most_cells)
    return "the largest allowed grid, " + std::to_string(scene.accuracy.most_cells) + " cells";
  const AccuracyTarget& target = scene.accuracy;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  if (nodes <= target.most_nodes) return {};
  const std::string cells = "the memory for " + std::to_string(grid.nx) + " cells";
  if (std::isnan(target.bytes_per_node)) return cells;
  return cells + " (about " + gigabytes(nodes * target.bytes_per_node) + "; this run may take " +
         gigabytes(target.most_nodes * target.bytes_per_node) + " of the free memory)";
}

// The grid on a domain that leaves enough of the target for the mesh; else the grid of the scene and the limit that was
// exceeded.
std::pair<core::Grid, std::string> domain_for(const Scene& scene, const DomainError& error) {
  if (std::isnan(error.left(1.0))) return {scene.grid, "the error of the domain, which could not be estimated"};
  // On longer domains the coarsest grids no longer resolve the contact, and the cycles fail.
  const Tuning& tuning = scene.tuning;
  const double longest = std::min(tuning.longest_domain * contact::extent(scene.contact.shape).X,
                                  tuning.longest_in_contacts * scene.contact.size);
  std::string stopped;
  for (const double share : {tuning.share_of_domain, tuning.larger_share_of_domain}) {
    double size = 1.0;
    while (error.left(size) > share * scene.accuracy.error && -size * scene.grid.X_a < 2.0 * longest)
      size *= step_of_size;
    const core::Grid larger = size > 1.0 ? on_larger_domain(scene.grid, size, sides_of(scene)) : scene.grid;
    const std::string forbids = -larger.X_a > longest
                                    ? "the length of the domain: more than " + std::to_string(std::lround(longest)) +
                                          " Hertz radii would be needed"
                                    : forbidden(scene, larger);
    if (forbids.empty()) return {larger, ""};
    if (stopped.empty()) stopped = forbids;
  }
  return {scene.grid, stopped};
}

Solution on_finer_grid(const Scene& finer, const Solution& coarser, const SolveOnGrid& solve_on_grid,
                       const ProgressCallback& progress) {
  try {
    Solution solution = refined(finer, coarser, progress);
    if (solution.converged) return solution;
  } catch (const core::SolverError&) {
    // Then by all strategies from the Hertz pressure.
  }
  return solve_on_grid(finer);
}

}  // namespace

std::vector<Scene> domain_series(const Scene& scene) {
  const bool halved = scene.grid.nx % 128 == 0 && scene.grid.ny % 2 == 0;
  return series_from(scene, halved ? core::coarsened(scene.grid) : scene.grid);
}

Solution solve_to_accuracy(const Scene& asked, const SolveOnGrid& solve_on_grid, const ProgressCallback& progress,
                           bool reuses_coarse) {
  const double began = core::now();
  const double target = asked.accuracy.error;
  Scene scene = asked;
  double of_domain = 0.0;
  std::string stopped;
  if (asked.accuracy.domain_is_free) {
    const DomainError error = domain_error(asked, solve_on_grid);
    std::tie(scene.grid, stopped) = domain_for(asked, error);
    of_domain = error.left((scene.grid.X_b - scene.grid.X_a) / (asked.grid.X_b - asked.grid.X_a));
  }
  // If the domain cannot be made large enough, the mesh is refined only to the target itself.
  const double allowed = stopped.empty() ? target - of_domain : target;
  Solution solution = solve_on_grid(scene);
  bool by_extrapolation = false;
  bool mesh_met = false;
  bool interrupted = false;
  while (solution.converged) {
    mesh_met = best_error(solution.error_bars) <= allowed;
    if (mesh_met) {
      by_extrapolation = !(plain_error(solution.error_bars) <= allowed);
      break;
    }
    const double predicted = predicted_cells(scene, solution, allowed);
    const bool reachable = predicted <= scene.accuracy.most_cells &&
                           forbidden(scene, with_cells(scene.grid, static_cast<int>(predicted))).empty();
    if (!reachable && extrapolated_error(solution.error_bars) <= allowed) {
      mesh_met = by_extrapolation = true;
      break;
    }
    const core::Grid next = with_cells(scene.grid, reachable ? static_cast<int>(predicted) : 2 * scene.grid.nx);
    if (const std::string limit = forbidden(scene, next); !limit.empty()) {
      if (stopped.empty()) stopped = limit;
      break;
    }
    const core::Grid solved = scene.grid;
    scene.grid = next;
    try {
      solution = reuses_coarse ? on_finer_grid(scene, solution, solve_on_grid, progress) : solve_on_grid(scene);
    } catch (const core::Interrupted&) {  // the last solution is still valid
      scene.grid = solved;
      stopped = "an interruption";
      interrupted = true;
      break;
    }
  }
  if (asked.accuracy.domain_is_free && std::isfinite(of_domain)) solution.domain_error_Hc = of_domain;
  solution.error_bars = error_bars_of(scene, solution);
  solution.warnings = warnings_of(scene, solution);
  if (!solution.converged) stopped = solution.failed_check;
  solution.accuracy = {target, mesh_met && stopped.empty(), by_extrapolation, stopped, interrupted};
  if (solution.converged && !solution.accuracy.met) {
    solution.converged = false;
    solution.failed_check = "the accuracy " + percent(target) + " was not reached because of " + stopped +
                            "; estimated error of Hc " + percent(solution.error_bars.Hc.total()) + ", of Hm " +
                            percent(solution.error_bars.Hm.total()) + " on " + std::to_string(solution.grid.nx) +
                            " cells, and of the domain " + percent(solution.error_bars.domain);
  }
  solution.seconds = core::now() - began;
  return solution;
}

}  // namespace ehl::steady
