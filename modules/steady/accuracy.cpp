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
#include "fmg/start.hpp"
#include "steady/climb.hpp"
#include "steady/larger_domain.hpp"
#include "steady/resolution.hpp"
#include "steady/warnings.hpp"

namespace ehl::steady {
namespace {

/// Of the target, left to a domain that is free; the second where the first needs a domain that is forbidden.
constexpr double shares_of_domain[] = {0.5, 0.7};
/// A domain is made larger in steps of this, in thought.
constexpr double step_of_size = 1.01;
/// Cells of the largest coarse solution that is spent on the domain.
constexpr int most_coarse_cells = 1024;
/// In Hertz radii, and in units of contact_size: on longer ones the coarsest grids no longer hold the contact, and the
/// cycles fail.
constexpr double longest_domain = 200.0;
constexpr double longest_in_contacts = 72.0;
/// The foretold level is one more where it would leave more than this of what is allowed.
constexpr double sure = 0.95;
constexpr double tolerance_of_coarse = 1e-6;

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

// The film on a coarse mesh, solved well: Hc and the fitted minimum.
Scene coarse_scene(const Scene& scene, const core::Grid& grid) {
  Scene coarse = scene;
  coarse.grid = grid;
  coarse.deformation = mlmi::fitting(coarse.deformation, grid);
  coarse.accuracy = {};
  coarse.adjoint_errors = false;
  coarse.multigrid.tolerance = tolerance_of_coarse;
  return coarse;
}

// What a domain cuts off, relative to the film: pressure of the inlet, which falls with the third power of the size;
// load of the far field, which falls with the first (domain_error.hpp). Never less than what falls with the square and
// is told by doubling the domain once: three quarters of that are gained.
struct DomainError {
  double square = 0.0;
  double inlet = 0.0;
  double load = 0.0;
  double left(double size) const {
    return std::max(square / (size * size), inlet / (size * size * size) + load / size);
  }
};

// From what doubling gains, and doubling again; no second gain, no more than the square.
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
// The nodes are the same; still, where the minimum moves on to another node, the node's film or the fitted one jumps.
double gain_of_Hm(const LevelRow& from, const LevelRow& to) {
  return std::min(change(from, to, &LevelRow::Hm), change(from, to, &LevelRow::Hm_fitted));
}

std::vector<Scene> series_from(const Scene& scene, core::Grid grid) {
  std::vector<Scene> series;
  for (int size = 1; size <= 4; size *= 2, grid = doubled(grid, sides_of(scene))) {
    if (size == 4 && grid.nx > most_coarse_cells) break;
    series.push_back(coarse_scene(scene, grid));
  }
  return series;
}

// Of Hc or Hm, the worse; NaN where a solution fails.
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

// On half as many cells; on those of the scene where so few have no solution, as at the ends of a roller.
DomainError domain_error(const Scene& scene, const SolveOnGrid& solve_on_grid) {
  const DomainError coarse = domain_error(domain_series(scene), solve_on_grid);
  return std::isnan(coarse.square) ? domain_error(series_from(scene, scene.grid), solve_on_grid) : coarse;
}

// The next levels up to the grid of `finer`, from the solution on a coarser one.
Solution refined(const Scene& finer, const Solution& coarser, const ProgressCallback& progress) {
  fmg::Run run = begin_climb(finer, {}, progress);
  std::size_t l = 0;
  while (l < run.finest() && run.hierarchy.levels[l].grid.nx < coarser.grid.nx) ++l;
  run.record.levels = coarser.levels;
  run.record.history = coarser.history;
  run.plan.first = l;
  fmg::start_from_state(run.hierarchy, l, {core::on_patch(run.hierarchy.levels[l].grid, coarser.P), coarser.H00});
  fmg::ascend(run, l);
  Solution solution = end_climb(finer, std::move(run));
  solution.method = coarser.method;
  solution.attempts = coarser.attempts;
  solution.continuation = coarser.continuation;
  solution.error_bars = error_bars_of(finer, solution);
  return solution;
}

double worst(double Hc, double Hm) { return std::isnan(Hc + Hm) ? std::nan("") : std::max(Hc, Hm); }
double plain_error(const ErrorBars& bars) { return worst(bars.Hc.total(), bars.Hm.total()); }
// Of what is shown first.
double best_error(const ErrorBars& bars) {
  const double best = worst(bars.Hc_best.error, bars.Hm_best.error);
  return std::isnan(best) ? plain_error(bars) : best;
}
double extrapolated_error(const ErrorBars& bars) {
  return worst(bars.Hc_extrapolated.error, bars.Hm_extrapolated.error);
}

// Cells of the level that will do for the values shown first, by the scheme's order; the next where the error is
// unknown.
double foretold_cells(const Scene& scene, const Solution& solution, double allowed) {
  double error = best_error(solution.error_bars);
  double cells = solution.grid.nx;
  do {
    cells *= 2.0;
    error /= std::exp2(reynolds::order(scene.wedge));
  } while (error > sure * allowed);
  return cells;
}

// What forbids a grid; empty when nothing does.
std::string forbidden(const Scene& scene, const core::Grid& grid) {
  if (grid.nx > scene.accuracy.most_cells)
    return "the level limit of " + std::to_string(scene.accuracy.most_cells) + " cells";
  const AccuracyTarget& target = scene.accuracy;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  if (nodes <= target.most_nodes) return {};
  const std::string cells = "the memory for " + std::to_string(grid.nx) + " cells";
  if (std::isnan(target.bytes_per_node)) return cells;
  return cells + " (about " + gigabytes(nodes * target.bytes_per_node) + "; this run may take " +
         gigabytes(target.most_nodes * target.bytes_per_node) + " of what is free)";
}

// The grid on the domain that leaves enough for the mesh; or that of the scene and what forbids a larger one.
std::pair<core::Grid, std::string> domain_for(const Scene& scene, const DomainError& error) {
  if (std::isnan(error.left(1.0))) return {scene.grid, "the error of the domain, which could not be estimated"};
  const double longest = std::min(longest_domain * contact::extent(scene.shape).X,
                                  longest_in_contacts * contact_size(scene.M, scene.L, scene.shape));
  std::string stopped;
  for (const double share : shares_of_domain) {
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
    // From the Hertz pressure then, by all ways that there are.
  }
  return solve_on_grid(finer);
}

}  // namespace

std::vector<Scene> domain_series(const Scene& scene) {
  const bool halved = scene.grid.nx % 128 == 0 && scene.grid.ny % 2 == 0;
  return series_from(scene, halved ? core::coarsened(scene.grid) : scene.grid);
}

Solution solve_to_accuracy(const Scene& asked, const SolveOnGrid& solve_on_grid, const ProgressCallback& progress,
                           bool climbs) {
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
  // What stopped the domain is a reason to do no more than the mesh deserves.
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
    const double foretold = foretold_cells(scene, solution, allowed);
    const bool reachable = foretold <= scene.accuracy.most_cells &&
                           forbidden(scene, with_cells(scene.grid, static_cast<int>(foretold))).empty();
    if (!reachable && extrapolated_error(solution.error_bars) <= allowed) {
      mesh_met = by_extrapolation = true;
      break;
    }
    const core::Grid next = with_cells(scene.grid, reachable ? static_cast<int>(foretold) : 2 * scene.grid.nx);
    if (const std::string limit = forbidden(scene, next); !limit.empty()) {
      if (stopped.empty()) stopped = limit;
      break;
    }
    const core::Grid solved = scene.grid;
    scene.grid = next;
    try {
      solution = climbs ? on_finer_grid(scene, solution, solve_on_grid, progress) : solve_on_grid(scene);
    } catch (const core::Interrupted&) {  // what there is so far is a solution too
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
    solution.failed_check = "the accuracy " + percent(target) + " was not reached, it was stopped by " + stopped +
                            "; estimated error of Hc " + percent(solution.error_bars.Hc.total()) + ", of Hm " +
                            percent(solution.error_bars.Hm.total()) + " on " + std::to_string(solution.grid.nx) +
                            " cells, and of the domain " + percent(solution.error_bars.domain);
  }
  solution.seconds = core::now() - began;
  return solution;
}

}  // namespace ehl::steady
