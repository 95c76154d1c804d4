#include "steady/solve.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "reynolds/flux.hpp"
#include "steady/accuracy.hpp"
#include "steady/domain_error.hpp"
#include "steady/mixed.hpp"
#include "steady/passes.hpp"
#include "steady/strategies.hpp"
#include "steady/warnings.hpp"

namespace ehl::steady {
namespace {

// Share of the total time for the flooded contact: with a meniscus cycles converge half as fast.
constexpr double share_of_flooded = 1.0 / 3.0;

constexpr double brim = std::numeric_limits<double>::infinity();

// On a line contact no oil flows aside: a supply above the flow through the contact fills the gap as far as the domain
// reaches, which is the flooded contact. From other states the cycles would fill the gap node by node.
bool more_than_goes_through(const Scene& scene, const Solution& flooded) {
  return !reynolds::flows_aside(scene.grid) && flooded.converged &&
         scene.supply(0.0) >= flooded.verification.flow_through;
}

// Scales the supply on coarse grids by their own flooded film.
std::function<double(int nx)> share_by_film(const Solution& flooded) {
  return [levels = flooded.levels](int nx) {
    for (const LevelRow& row : levels)
      if (row.nx == nx && row.Hc > 0.0) return row.Hc / levels.back().Hc;
    return 1.0;
  };
}

// Solves the flooded contact first, then the one with the supply.
Solution solve_starved(const Scene& scene, const ProgressCallback& progress) {
  const double began = core::now();
  Scene full = scene;
  full.supply = {};
  full.adjoint_errors = false;
  const Solution flooded = solve_by_strategies(full, multigrid::part_of(progress, 0.0, share_of_flooded));
  const double of_flooded = core::now() - began;
  const auto find = [](const Scene& one, const ProgressCallback& part) { return solve_by_strategies(one, part); };
  const ProgressCallback rest = multigrid::part_of(progress, share_of_flooded, 1.0);
  Scene starved = scene;
  const bool all_goes_through = !reynolds::flows_aside(scene.grid) && flooded.converged;
  if (all_goes_through) starved.supply_share = share_by_film(flooded);
  if (more_than_goes_through(scene, flooded)) starved.supply = [](double) { return brim; };
  Solution solution = scene.passes.number > 1
                          ? solve_passes(scene, carried_at_centre(scene, flooded), find, go_on, rest)
                          : solve_by_strategies(starved, rest, all_goes_through ? &flooded : nullptr);
  if (!solution.converged && starved.supply_share) {
    // For heavily loaded line contacts the same supply on all grids may converge if the scaled one does not.
    starved.supply_share = {};
    try {
      if (Solution other = solve_by_strategies(starved, rest); other.converged) {
        other.attempts.insert(other.attempts.begin(), solution.attempts.begin(), solution.attempts.end());
        solution = std::move(other);
      }
    } catch (const core::SolverError&) {
      // The present state can still be reported.
    }
  }
  solution.starvation = starvation_of(scene, solution, flooded);
  solution.starvation->seconds = core::now() - began - of_flooded;
  return solution;
}

Solution solve_on_grid(const Scene& scene, const ProgressCallback& progress) {
  const double began = core::now();
  Solution solution = scene.supply          ? solve_starved(scene, progress)
                      : scene.boundary_film ? solve_mixed(scene, progress)
                                            : solve_by_strategies(scene, progress);
  // With a supply a meniscus inside the domain ends the inlet.
  if (!scene.supply && rough_domain_error(scene) > scene.tuning.domain_worth_a_look)
    solution.domain_error_Hc = estimate_domain_error(scene);
  if (const std::string advice = advice_for_cutting_ends(scene, solution);
      !solution.converged && scene.one_start_only.empty() && !advice.empty())
    solution.failed_check = advice;
  solution.error_bars = error_bars_of(scene, solution);
  solution.warnings = warnings_of(scene, solution);
  solution.seconds = core::now() - began;
  return solution;
}

}  // namespace

Solution solve(const Scene& scene, const ProgressCallback& progress) {
  if (std::isnan(scene.accuracy.error)) return solve_on_grid(scene, progress);
  return solve_to_accuracy(
      scene, [&](const Scene& one) { return solve_on_grid(one, progress); }, progress);
}

}  // namespace ehl::steady
