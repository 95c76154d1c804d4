#include "steady/solve.hpp"

#include <optional>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "steady/climb.hpp"
#include "steady/domain_error.hpp"
#include "steady/warnings.hpp"

namespace ehl::steady {
namespace {

/// The first start is fast and right for most contacts. The later ones begin on a grid that holds the contact better,
/// keep the coarsest grid finer, and are more cautious: for high loads and for L near zero or above 20.
constexpr Start starts[] = {
    {.cells = 64, .sweeps = 20, .cycles = 6, .coarsest = 32, .balances = 10, .caution_at_first = 0.7, .caution = 1.0},
    {.cells = 64, .sweeps = 40, .cycles = 10, .coarsest = 32, .balances = 30, .caution_at_first = 0.5, .caution = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 6, .coarsest = 64, .balances = 30, .caution_at_first = 0.7, .caution = 1.0},
    {.cells = 128, .sweeps = 40, .cycles = 10, .coarsest = 64, .balances = 30, .caution_at_first = 0.7, .caution = 0.7},
    {.cells = 256, .sweeps = 80, .cycles = 10, .coarsest = 64, .balances = 30, .caution_at_first = 0.5, .caution = 0.7},
};

/// A rough bound on the error of the domain above which two coarse solutions are spent on estimating it.
constexpr double worth_a_look = 0.01;

bool better(const Solution& one, const std::optional<Solution>& other) {
  return !other || one.converged || one.levels.back().residual < other->levels.back().residual;
}

}  // namespace

Solution solve(const Scene& scene, const ProgressCallback& progress) {
  const double began = core::now();
  std::optional<Solution> best;
  std::string last_error;
  std::vector<Attempt> attempts;
  for (const Start& start : starts) {
    // A start for finer grids than the scene has brings nothing new.
    if (attempts.size() > 1 && start.cells > scene.grid.nx) break;
    const double start_began = core::now();
    attempts.push_back({"full multigrid, start " + std::to_string(attempts.size() + 1), "", 0.0});
    try {
      Solution solution = climb(scene, start, progress);
      attempts.back().reason = solution.failed_check;
      if (better(solution, best)) best = std::move(solution);
    } catch (const core::SolverError& error) {
      last_error = error.what();
      attempts.back().reason = last_error;
    }
    attempts.back().seconds = core::now() - start_began;
    if (best && best->converged) break;
  }
  if (!best)
    throw core::SolverError(last_error + " from every start; use more cells, or a domain closer to the contact");
  best->attempts = std::move(attempts);
  if (rough_domain_error(scene) > worth_a_look) best->domain_error_Hc = estimate_domain_error(scene);
  best->warnings = warnings_of(scene, *best);
  best->seconds = core::now() - began;
  return std::move(*best);
}

}  // namespace ehl::steady
