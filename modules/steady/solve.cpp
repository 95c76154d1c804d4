#include "steady/solve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "steady/accuracy.hpp"
#include "steady/continuation.hpp"
#include "steady/domain_error.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/newton_fallback.hpp"
#include "steady/passes.hpp"
#include "steady/resolution.hpp"
#include "steady/starts.hpp"
#include "steady/warnings.hpp"

namespace ehl::steady {
namespace {

/// The name of a strategy for readers, and its code for scripts and plots.
struct Strategy {
  std::string method, path;
};

/// The strategies that were tried, and the best result so far.
class Search {
 public:
  void try_strategy(const Strategy& which, const std::function<Solution()>& strategy) {
    const double began = core::now();
    attempts_.push_back({.method = which.method, .reason = "", .path = which.path});
    try {
      Solution solution = strategy();
      attempts_.back().reason = solution.failed_check;
      if (better(solution)) {
        best_ = std::move(solution);
        shown_ = attempts_.size() - 1;
      }
    } catch (const core::SolverError& error) {
      last_error_ = error.what();
      attempts_.back().reason = last_error_;
    }
    attempts_.back().seconds = core::now() - began;
  }

  const std::optional<Solution>& best() const { return best_; }
  const std::string& last_error() const { return last_error_; }
  std::size_t attempts() const { return attempts_.size(); }
  bool tried(const Strategy& which) const {
    return std::ranges::any_of(attempts_, [&](const Attempt& one) { return one.path == which.path; });
  }
  /// True if no other strategy can help: solved, stopped by the deck's limit of cycles, or a mesh without a solution.
  bool over() const {
    return best_ && (best_->converged || best_->end == CyclesEnd::limit || best_->end == CyclesEnd::no_solution);
  }

  Solution result() {
    if (!best_)
      throw core::SolverError(
          last_error_ + "; no other strategy gave a state that can be shown: try another domain or number of cells");
    best_->method = attempts_[shown_].method;
    best_->path = attempts_[shown_].path;
    best_->attempts = std::move(attempts_);
    return std::move(*best_);
  }

 private:
  bool better(const Solution& one) const {
    return !best_ || one.converged || one.levels.back().residual < best_->levels.back().residual;
  }

  std::optional<Solution> best_;
  std::size_t shown_ = 0;
  std::vector<Attempt> attempts_;
  std::string last_error_;
};

double nodes_of(const Scene& scene) { return static_cast<double>(scene.grid.nodes_x()) * scene.grid.nodes_y(); }

Strategy newton_after_cycles() { return {"Newton-Krylov after the cycles", "newton-after-cycles"}; }

// The cycles may find no state for the meniscus of a supply; Newton's method does.
void try_newton_after_cycles(const Scene& scene, const ProgressCallback& progress, Search& search) {
  if (scene.polish == Polish::off || (scene.polish == Polish::fallback && nodes_of(scene) > most_nodes_of_newton))
    return;
  if (search.best())
    search.try_strategy(newton_after_cycles(),
                        [&] { return refine_by_newton(scene, usual_start(), *search.best(), progress); });
}

// Line contacts: a coarse grid lets more or less oil through than the finest, so that a supply near this flow fills the
// inlet of some grids only and cycles diverge between them. Newton's method solves the finest grid from its own flooded
// state.
void try_newton_from(const Solution& flooded, const Scene& scene, const ProgressCallback& progress, Search& search) {
  if (scene.polish == Polish::off || nodes_of(scene) > most_nodes_of_newton) return;
  Solution start = flooded;
  start.history.clear();
  search.try_strategy({"Newton-Krylov from the flooded contact", "newton"},
                      [&] { return refine_by_newton(scene, usual_start(), start, progress); });
}

// Beside a slender contact the oil on a first grid is far from its final place, and no start brings it there; load
// continuation does. [bench: load_continuation_of_slender]
bool oil_is_astray(const Scene& scene, const Search& search) {
  if (!scene.supply || scene.grid.line) return false;
  return search.best() ? !search.best()->levels.back().solved() : elongated(scene.tuning, scene.contact.shape);
}

// in: by_load, the load continuation, for a contact that needs it right after the first start.
void try_full_multigrid(const Scene& scene, const ProgressCallback& progress, Search& search, const Solution* flooded,
                        const std::function<void()>& by_load) {
  const double slender = scene.contact.slenderness;
  int number = 0;
  for (const Start& start : starts_of(scene)) {
    const bool first = ++number == 1;
    // A start for finer grids than the scene has does not differ from the earlier ones.
    if (number > 2 && start.coarseness == 0.0 && start.cells * slender > scene.grid.nx * core::stretch(scene.grid))
      return;
    Strategy strategy{"full multigrid", "full-multigrid"};
    if (!first) {
      strategy.method += ", start " + std::to_string(number);
      strategy.path += "-" + std::to_string(number);
    }
    search.try_strategy(strategy, [&] { return solve_by_multigrid(scene, start, progress); });
    const bool stalls = search.best() && search.best()->levels.back().residual > scene.tuning.stalled_residual;
    if (!search.over() && first && scene.supply && stalls) try_newton_after_cycles(scene, progress, search);
    if (!search.over() && first && flooded != nullptr) try_newton_from(*flooded, scene, progress, search);
    if (!search.over() && first && oil_is_astray(scene, search)) by_load();
    if (search.over() || !scene.one_start_only.empty()) return;
  }
}

// errors: core::SolverError with the last reason.
Solution by_full_multigrid(const Scene& scene, const ProgressCallback& progress) {
  Search search;
  try_full_multigrid(scene, progress, search, nullptr, [] {});
  if (!search.best()) throw core::SolverError(search.last_error());
  return search.result();
}

void try_newton(const Scene& scene, const ProgressCallback& progress, Search& search) {
  const double most = search.tried(newton_after_cycles()) ? most_nodes_of_second_newton : most_nodes_of_newton;
  if (scene.polish == Polish::fallback && nodes_of(scene) > most) return;
  try_newton_after_cycles(scene, progress, search);
  if (!search.over())
    search.try_strategy({"Newton-Krylov", "newton"}, [&] { return solve_by_newton(scene, usual_start(), progress); });
}

// The solution by the first strategy that succeeds. in: the flooded solution of a starved line contact, or none.
Solution find_from(const Solution* flooded, const Scene& scene, const ProgressCallback& progress) {
  Search search;
  std::vector<ContinuationStep> steps;
  using Path = ContinuationParameters::Path;
  const auto by_load = [&] {
    const Strategy strategy{"load continuation", "load-continuation"};
    if (scene.continuation.path == Path::off || search.over() || search.tried(strategy)) return;
    search.try_strategy(strategy, [&] {
      return solve_by_continuation(
          scene, safe_start(), [&](const Scene& light) { return by_full_multigrid(light, progress); }, progress, steps);
    });
  };
  const bool once = !scene.one_start_only.empty();
  if (scene.continuation.path != Path::load) try_full_multigrid(scene, progress, search, flooded, by_load);
  if (!once || scene.continuation.path == Path::load) by_load();
  if (!once && scene.polish != Polish::off && !search.over()) try_newton(scene, progress, search);
  if (once && !search.best()) throw core::SolverError(scene.one_start_only + "; " + search.last_error());
  Solution solution = search.result();
  if (once && !solution.converged)
    // The record of attempts has the other reasons.
    solution.failed_check = scene.one_start_only;
  solution.continuation = std::move(steps);
  return solution;
}

Solution find(const Scene& scene, const ProgressCallback& progress) { return find_from(nullptr, scene, progress); }

// Share of the total time for the flooded contact: with a meniscus cycles converge half as fast.
constexpr double share_of_flooded = 1.0 / 3.0;

constexpr double brim = std::numeric_limits<double>::infinity();

// On a line contact no oil flows aside: a supply above the flow through the contact fills the gap as far as the domain
// reaches, which is the flooded contact. From other states the cycles would fill the gap node by node.
bool more_than_goes_through(const Scene& scene, const Solution& flooded) {
  return scene.grid.line && flooded.converged && scene.supply(0.0) >= flooded.verification.flow_through;
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
Solution find_starved(const Scene& scene, const ProgressCallback& progress) {
  const double began = core::now();
  Scene full = scene;
  full.supply = {};
  full.adjoint_errors = false;
  const Solution flooded = find(full, multigrid::part_of(progress, 0.0, share_of_flooded));
  const double of_flooded = core::now() - began;
  const ProgressCallback rest = multigrid::part_of(progress, share_of_flooded, 1.0);
  Scene starved = scene;
  if (scene.grid.line && flooded.converged) starved.supply_share = share_by_film(flooded);
  if (more_than_goes_through(scene, flooded)) starved.supply = [](double) { return brim; };
  Solution solution = scene.passes.number > 1
                          ? solve_passes(scene, carried_at_centre(scene, flooded), find, go_on, rest)
                          : find_from(scene.grid.line && flooded.converged ? &flooded : nullptr, starved, rest);
  if (!solution.converged && starved.supply_share) {
    // For heavily loaded line contacts the same supply on all grids may converge if the scaled one does not.
    starved.supply_share = {};
    try {
      if (Solution other = find(starved, rest); other.converged) {
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
  Solution solution = scene.supply ? find_starved(scene, progress) : find(scene, progress);
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
