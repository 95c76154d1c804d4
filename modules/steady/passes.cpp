#include "steady/passes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "judgement/stopping.hpp"
#include "multigrid/mass_balance.hpp"
#include "multigrid/start.hpp"
#include "steady/layer_error.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/newton_fallback.hpp"

namespace ehl::steady {
namespace {

/// Cells and coarsest grid for a pass that starts from the previous one.
constexpr Start restart{.cells = 64, .coarsest = 32, .balances = 10};

std::vector<double> fresh_layer(const Scene& scene) {
  std::vector<double> layer;
  for (int j = 0; j <= scene.grid.ny; ++j) layer.push_back(scene.supply(scene.grid.Y(j)));
  return layer;
}

std::vector<double> left_behind(const Solution& solution) {
  std::vector<double> layer;
  for (int j = 0; j <= solution.grid.ny; ++j) layer.push_back(solution.Q(solution.grid.nx, j));
  return layer;
}

// Linear interpolation between the lines of the grid.
std::function<double(double Y)> supply_of(const core::Grid& grid, std::vector<double> layer) {
  return [grid, layer = std::make_shared<const std::vector<double>>(std::move(layer))](double Y) {
    const double at = std::clamp((Y - grid.Y_a) / grid.hy(), 0.0, static_cast<double>(grid.ny));
    const auto j = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(grid.ny - 1));
    const double share = at - static_cast<double>(j);
    return share == 0.0 ? (*layer)[j] : (1.0 - share) * (*layer)[j] + share * (*layer)[j + 1];
  };
}

// Cycles from the state of the previous pass.
Solution cycles_from(const Scene& scene, const Solution& before, const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(scene, restart, progress);
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t l) {
    const core::Patch& grid = run.hierarchy.levels[l].grid;
    multigrid::start_from_state(run.hierarchy, l, {core::on_patch(grid, before.P), before.H00});
  };
  multigrid::for_levels(run, run.finest(), run.hierarchy.levels.size(), begin, multigrid::solve_level);
  if (!run.record.converged) multigrid::balance_mass(run.hierarchy, run.hierarchy.finest());
  return solution_of(scene, std::move(run));
}

/// True if a pass with chattering nodes still counts, with a warning: a node at the edge of the film may be consistent
/// neither as full nor as cavitated. Its residual is that of a single node, and oil is conserved.
bool only_chatters(const Scene& scene, const Solution& solution) {
  const LevelRow& row = solution.levels.back();
  return row.Hm > 0.0 && row.residual <= scene.tuning.chattering_residual &&
         row.load_error <= scene.solver.judgement.loose_load_error &&
         std::abs(solution.oil.imbalance()) <= scene.solver.judgement.largest_oil_imbalance;
}

Pass row_of(const Scene& scene, const Solution& solution, int number, double carried_flooded) {
  Pass row;
  row.number = number;
  row.supply = scene.supply(0.0);
  row.supply_ratio = row.supply / carried_flooded;
  row.factor = carried_at_centre(scene, solution) / carried_flooded;
  row.Hc = solution.levels.back().Hc;
  row.Hm = solution.levels.back().Hm;
  row.P_max = core::maximum(solution.P).value;
  row.meniscus_X = meniscus_on(solution, solution.grid.ny / 2);
  row.left = left_behind(solution)[static_cast<std::size_t>(solution.grid.ny / 2)];
  row.in = solution.oil.in;
  row.aside = solution.oil.aside;
  row.imbalance = solution.oil.imbalance();
  row.steps = solution.newton.empty() ? solution.levels.back().cycles : static_cast<int>(solution.newton.size());
  row.first_order = solution.chattering_nodes;
  row.residual = solution.levels.back().residual;
  return row;
}

// The share of the progress of one pass; all passes count as equally long.
ProgressCallback part_of(const ProgressCallback& progress, int pass, int passes) {
  return multigrid::part_of(progress, (pass - 1.0) / passes, static_cast<double>(pass) / passes);
}

}  // namespace

std::vector<double> next_layer(const Passes& rule, const std::vector<double>& left, const std::vector<double>& fresh) {
  std::vector<double> layer(left.size());
  double sum = 0.0;  // trapezoidal rule
  for (std::size_t j = 0; j < left.size(); ++j) {
    layer[j] = rule.returning * left[j] + rule.renewed * fresh[j];
    sum += (j == 0 || j + 1 == left.size() ? 0.5 : 1.0) * layer[j];
  }
  const double mean = sum / static_cast<double>(left.size() - 1);
  for (double& h : layer) h += rule.levelled * (mean - h);
  return layer;
}

// The set of cavitated nodes hardly changes between passes, so that Newton's method converges in a few steps.
// [bench: go_on]
std::optional<Solution> go_on(const Scene& scene, const Solution& before, const ProgressCallback& progress) {
  Scene next = scene;
  // The errors of what each pass leaves behind add up.
  next.solver.tolerance = std::fmin(scene.tuning.tolerance_between_passes, scene.solver.tolerance);
  const double nodes = static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y();
  if (scene.polish != Polish::off && nodes <= most_nodes_of_newton) {
    Solution solution = follow_by_newton(next, restart, before, progress);
    if (solution.converged || only_chatters(scene, solution)) return solution;
  }
  try {
    Solution solution = cycles_from(next, before, progress);
    if (solution.converged || only_chatters(scene, solution)) return solution;
  } catch (const core::SolverError&) {
    // Then without the previous solution.
  }
  return {};
}

std::vector<double> supplies_on_half_the_cells(const Scene& scene, int passes, const FindSolution& find,
                                               const GoOn& go_on) {
  Scene now = scene;
  if (passes == 1) return {scene.supply(0.0)};
  if (scene.grid.nx % 2 != 0 || scene.grid.ny % 2 != 0) return {};
  now.grid = core::coarsened(scene.grid);
  now.adjoint_errors = false;
  const std::vector<double> fresh = fresh_layer(now);
  std::vector<double> supplies{scene.supply(0.0)};
  try {
    std::optional<Solution> solution = find(now, {});
    while (solution && static_cast<int>(supplies.size()) < passes) {
      if (!solution->converged && !only_chatters(scene, *solution)) break;
      now.supply = supply_of(now.grid, next_layer(scene.passes, left_behind(*solution), fresh));
      supplies.push_back(now.supply(0.0));
      if (static_cast<int>(supplies.size()) == passes) break;
      std::optional<Solution> next = go_on(now, *solution, {});
      solution = next ? std::move(next) : std::optional<Solution>(find(now, {}));
    }
  } catch (const core::SolverError&) {
    // A mesh without a solution says nothing about the remaining passes.
  }
  return supplies;
}

Solution solve_passes(const Scene& scene, double carried_flooded, const FindSolution& find, const GoOn& go_on,
                      const ProgressCallback& progress) {
  const int number = scene.passes.number;
  const std::vector<double> fresh = fresh_layer(scene);
  Scene now = scene;
  Solution solution = find(now, part_of(progress, 1, number));
  std::vector<Pass> rows;
  std::vector<std::vector<double>> tracks;
  bool chatters = false;
  for (int pass = 1;; ++pass) {
    rows.push_back(row_of(now, solution, pass, carried_flooded));
    rows.back().chatters = chatters;
    tracks.push_back(left_behind(solution));
    if (pass == number || !(solution.converged || chatters)) break;
    now.supply = supply_of(scene.grid, next_layer(scene.passes, tracks.back(), fresh));
    const ProgressCallback part = part_of(progress, pass + 1, number);
    std::optional<Solution> next = go_on(now, solution, part);
    chatters = next && !next->converged;
    if (!next || (pass + 1 == number && !chatters))
      if (Solution found = find(now, part); found.converged || !next) next = std::move(found);
    solution = std::move(*next);
  }
  if (chatters) {
    solution.converged = true;
    solution.failed_check.clear();
  }
  if (const int last = rows.back().number; !solution.converged)
    solution.failed_check =
        "pass " + std::to_string(last) + " of " + std::to_string(number) + ": " + solution.failed_check;
  if (solution.converged) judge_layers(scene, supplies_on_half_the_cells(scene, number, find, go_on), rows);
  solution.passes = std::move(rows);
  solution.tracks = std::move(tracks);
  return solution;
}

}  // namespace ehl::steady
