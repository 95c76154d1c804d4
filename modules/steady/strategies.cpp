#include "steady/strategies.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "reynolds/flux.hpp"
#include "steady/continuation.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/resolution.hpp"
#include "steady/starts.hpp"

namespace ehl::steady {
namespace {

using Path = ContinuationParameters::Path;

/// What was tried, and the best result so far.
struct Search {
  const Scene& scene;
  const ProgressCallback& progress;
  const Solution* flooded = nullptr;
  bool first_load = false;  ///< the first load of a load continuation, by full multigrid alone
  std::vector<Start> starts{};
  std::size_t next_start = 0;
  bool newton_early = false;  ///< Newton's method was tried after the first start
  std::optional<Solution> best{};
  std::size_t shown = 0;  ///< the attempt that led to it
  std::vector<Attempt> attempts{};
  std::string last_error{};
  std::vector<ContinuationStep> steps{};
};

/// True if no other strategy can help: solved, stopped by the deck's limit of cycles, or a mesh without a solution.
bool over(const Search& search) {
  return search.best &&
         (search.best->converged || search.best->end == CyclesEnd::limit || search.best->end == CyclesEnd::no_solution);
}

bool one_start_only(const Search& search) { return !search.scene.one_start_only.empty(); }
double nodes_of(const Scene& scene) { return static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y(); }

// ---- Conditions

bool first_start(const Search& search) {
  return (search.first_load || search.scene.continuation.path != Path::load) && search.next_start == 0 &&
         !search.starts.empty();
}
bool further_start(const Search& search) {
  return search.next_start > 0 && search.next_start < search.starts.size() && !one_start_only(search);
}

bool newton_may_follow_cycles(const Search& search) {
  const Polish polish = search.scene.polish;
  return search.best && polish != Polish::off &&
         (polish != Polish::fallback || nodes_of(search.scene) <= most_nodes_of_newton);
}

/// The cycles may find no state for the meniscus of a supply; Newton's method does.
bool meniscus_not_found(const Search& search) {
  return search.next_start > 0 && search.scene.supply && newton_may_follow_cycles(search);
}

/// Line contacts: a coarse grid lets more or less oil through than the finest, so that a supply near this flow fills
/// the inlet of some grids only and cycles diverge between them. Newton's method solves the finest grid from its own
/// flooded state.
bool flooded_line(const Search& search) {
  return search.next_start > 0 && search.flooded != nullptr && search.scene.polish != Polish::off &&
         nodes_of(search.scene) <= most_nodes_of_newton;
}

bool may_continue_load(const Search& search) {
  return !search.first_load && search.scene.continuation.path != Path::off &&
         std::ranges::none_of(search.attempts, [](const Attempt& one) { return one.path == "load-continuation"; });
}

/// Beside a slender contact the oil on a first grid is far from its final place, and no start brings it there; load
/// continuation does. [bench: load_continuation_of_slender]
bool oil_is_astray(const Search& search) {
  const Scene& scene = search.scene;
  if (search.next_start == 0 || !scene.supply || !reynolds::flows_aside(scene.grid) || !may_continue_load(search))
    return false;
  return search.best ? !search.best->levels.back().solved() : elongated(scene.tuning, scene.contact.shape);
}

bool load_continuation(const Search& search) {
  return may_continue_load(search) && (!one_start_only(search) || search.scene.continuation.path == Path::load);
}

/// On so many nodes Newton's method is tried once only.
bool newton(const Search& search) {
  if (search.first_load || one_start_only(search) || search.scene.polish == Polish::off) return false;
  const double most = search.newton_early ? most_nodes_of_second_newton : most_nodes_of_newton;
  return search.scene.polish != Polish::fallback || nodes_of(search.scene) <= most;
}
bool newton_after_cycles(const Search& search) { return newton(search) && newton_may_follow_cycles(search); }

// ---- Strategies

Solution next_start(Search& search) {
  return solve_by_multigrid(search.scene, search.starts[search.next_start++], search.progress);
}

Solution newton_from_best(Search& search) {
  return refine_by_newton(search.scene, usual_start(), *search.best, search.progress);
}
Solution newton_from_best_early(Search& search) {
  search.newton_early = true;
  return newton_from_best(search);
}

Solution newton_from_flooded(Search& search) {
  Solution start = *search.flooded;
  start.history.clear();
  return refine_by_newton(search.scene, usual_start(), start, search.progress);
}

Solution by_load(Search& search);

Solution nested_newton(Search& search) { return solve_by_newton(search.scene, usual_start(), search.progress); }

// The table, from top to bottom until the search is over.
struct Strategy {
  const char* method;  ///< for readers
  const char* path;    ///< the same as a code for scripts and plots
  bool (*when)(const Search& search);
  Solution (*solve)(Search& search);
  bool repeats = false;
};

constexpr Strategy strategies[] = {
    {"full multigrid", "full-multigrid", first_start, next_start},
    {"Newton-Krylov after the cycles", "newton-after-cycles", meniscus_not_found, newton_from_best_early},
    {"Newton-Krylov from the flooded contact", "newton", flooded_line, newton_from_flooded},
    {"load continuation", "load-continuation", oil_is_astray, by_load},
    {"full multigrid", "full-multigrid", further_start, next_start, true},
    {"load continuation", "load-continuation", load_continuation, by_load},
    {"Newton-Krylov after the cycles", "newton-after-cycles", newton_after_cycles, newton_from_best},
    {"Newton-Krylov", "newton", newton, nested_newton},
};

bool better(const Search& search, const Solution& one) {
  return !search.best || one.converged || one.levels.back().residual < search.best->levels.back().residual;
}

void attempt(Search& search, const Strategy& strategy) {
  const double began = core::now();
  Attempt row{.method = strategy.method, .reason = "", .path = strategy.path};
  if (strategy.repeats) {  // a further start
    row.method += ", start " + std::to_string(search.next_start + 1);
    row.path += "-" + std::to_string(search.next_start + 1);
  }
  search.attempts.push_back(std::move(row));
  try {
    Solution solution = strategy.solve(search);
    search.attempts.back().reason = solution.failed_check;
    if (better(search, solution)) {
      search.best = std::move(solution);
      search.shown = search.attempts.size() - 1;
    }
  } catch (const core::SolverError& error) {
    search.last_error = error.what();
    search.attempts.back().reason = search.last_error;
  }
  search.attempts.back().seconds = core::now() - began;
}

void run(Search& search) {
  search.starts = starts_of(search.scene);
  for (const Strategy& strategy : strategies) {
    bool again = true;
    while (again && !over(search) && strategy.when(search)) {
      attempt(search, strategy);
      again = strategy.repeats;
    }
  }
}

Solution result_of(Search& search) {
  Solution solution = std::move(*search.best);
  solution.method = search.attempts[search.shown].method;
  solution.path = search.attempts[search.shown].path;
  solution.attempts = std::move(search.attempts);
  solution.continuation = std::move(search.steps);
  return solution;
}

Solution by_load(Search& search) {
  const auto first_load = [&](const Scene& light) {
    Search by_multigrid{.scene = light, .progress = search.progress, .first_load = true};
    run(by_multigrid);
    if (!by_multigrid.best) throw core::SolverError(by_multigrid.last_error);
    return result_of(by_multigrid);
  };
  return solve_by_continuation(search.scene, safe_start(), first_load, search.progress, search.steps);
}

}  // namespace

Solution solve_by_strategies(const Scene& scene, const ProgressCallback& progress, const Solution* flooded) {
  Search search{.scene = scene, .progress = progress, .flooded = flooded};
  run(search);
  if (!search.best)
    throw core::SolverError(
        one_start_only(search)
            ? scene.one_start_only + "; " + search.last_error
            : search.last_error +
                  "; no other strategy gave a state that can be shown: try another domain or number of cells");
  Solution solution = result_of(search);
  // The record of attempts has the other reasons.
  if (one_start_only(search) && !solution.converged) solution.failed_check = scene.one_start_only;
  return solution;
}

}  // namespace ehl::steady
