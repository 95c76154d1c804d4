#include "steady/rescue.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "fmg/full_multigrid.hpp"
#include "newton/solve.hpp"
#include "steady/checks.hpp"
#include "steady/resolution.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

/// Relative residual on the grids below the finest: far below their discretization error.
constexpr double tolerance_on_the_way = 1e-6;
constexpr double tolerance_at_rounding = 1e-11;
/// From the Hertz pressure the number of steps grows with the number of cells.
constexpr int finest_from_hertz = 128;
/// Grids below the finest one that an estimate of its discretization error needs.
constexpr std::size_t levels_of_an_estimate = 2;

double final_tolerance(const Scene& scene) {
  return std::fmin(tolerance_at_rounding, scene.multigrid.tolerance);  // that of a NaN and a number is the number
}

// Newton on level l with its row in the table of levels.
newton::Result solve_level_by_newton(Climb& climb, std::size_t l, double tolerance) {
  const StateOfLevel start = state_of_level(climb.hierarchy, l);
  int steps = 0;
  const newton::Progress progress = [&](const newton::Step& step) {
    StateOfLevel now = start;
    now.residual = step.residual;
    report(climb, l, ++steps, newton::Parameters{}.max_steps, now);
    return true;
  };
  newton::Result result = newton::solve(climb.hierarchy, l, {.tolerance = tolerance}, progress);
  if (l == climb.finest()) climb.solution.newton = result.steps;
  return result;
}

// The checks of the finest grid on the state that Newton has left: no cycle foretells its error, the residual does.
void judge(Climb& climb) {
  const std::size_t l = climb.finest();
  Solution& solution = climb.solution;
  const StateOfLevel now = state_of_level(climb.hierarchy, l);
  record(climb, l, solution.levels.back().cycles, now);
  const LastCycle last{now, now, solution.levels.back().error_Hc, solution.levels.back().error_Hm};
  solution.verification = verification_of(last);
  const double tolerance =
      std::isfinite(climb.scene.multigrid.tolerance) ? climb.scene.multigrid.tolerance : tolerance_on_the_way;
  const std::string unmet = unmet_check(last, tolerance);
  solution.failed_check = unmet.empty() ? unmet : name_of_level(climb.hierarchy, l) + ": " + unmet;
  solution.converged = unmet.empty();
  solution.end = unmet.empty() ? CyclesEnd::content : CyclesEnd::stalled;
}

// What the cycles left below a finest grid that they did not solve says nothing about its discretization error: a new
// table of levels, with the two grids below it solved too.
void solve_levels_below(Climb& climb) {
  climb.solution.levels.clear();
  const std::size_t finest = climb.finest();
  std::vector<core::Field> injected;  // from level finest - 1 down
  for (std::size_t l = finest; l > climb.first && finest - l < levels_of_an_estimate; --l) {
    injected.emplace_back(climb.hierarchy.levels[l - 1].grid);
    transfer::restrict_injection(l == finest ? climb.hierarchy.finest().P : injected.end()[-2], injected.back());
  }
  const double H00 = climb.hierarchy.H00;
  for (std::size_t k = injected.size(); k > 0; --k) {
    const double began = core::now();
    const std::size_t l = finest - k;
    forget_work(climb.hierarchy);
    fmg::start_from_state(climb.hierarchy, l, injected[k - 1], H00);
    if (!solve_level_by_newton(climb, l, tolerance_on_the_way).converged) {
      climb.solution.levels.clear();
      continue;
    }
    climb.solution.levels.emplace_back();
    record(climb, l, 0, state_of_level(climb.hierarchy, l));
    climb.solution.levels.back().seconds = core::now() - began;
  }
}

}  // namespace

void polish(Climb& climb) {
  const double began = core::now();
  const bool was_converged = climb.solution.converged;
  const newton::Result result = solve_level_by_newton(climb, climb.finest(), final_tolerance(climb.scene));
  if (!result.converged) climb.solution.polish_failure = result.reason;
  if (result.converged || !was_converged) judge(climb);
  climb.solution.levels.back().seconds += core::now() - began;
}

Solution rescue_by_newton(const Scene& scene, const Start& start, const Solution& unsolved,
                          const ProgressCallback& progress) {
  Climb climb = begin_climb(scene, start, progress);
  const std::size_t l = climb.finest();
  fmg::Hierarchy& hierarchy = climb.hierarchy;
  const double began = core::now();
  climb.solution.levels = unsolved.levels;
  climb.solution.history = unsolved.history;
  fmg::start_from_state(hierarchy, l, part_on(hierarchy.finest().grid, unsolved.P), unsolved.H00);
  const newton::Result result = solve_level_by_newton(climb, l, final_tolerance(scene));
  if (result.converged) {
    const fmg::Kept kept{hierarchy.finest().P, hierarchy.H00};
    solve_levels_below(climb);
    climb.solution.levels.push_back(unsolved.levels.back());
    fmg::start_from_state(hierarchy, l, kept.P, kept.H00);
  }
  judge(climb);
  if (!result.converged) climb.solution.failed_check = result.reason;
  climb.solution.converged = climb.solution.converged && result.converged;
  climb.solution.levels.back().seconds += core::now() - began;
  return result_of(std::move(climb));
}

Solution climb_by_newton(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  Climb climb = begin_climb(scene, start, progress);
  bool solved = false;
  std::string last_reason;
  for (std::size_t l = climb.first; l <= climb.finest(); ++l) {
    const double began = core::now();
    forget_work(climb.hierarchy);
    if (solved)
      fmg::start_from_coarser(climb.hierarchy, l);
    else if (climb.hierarchy.levels[l].grid.nx <= finest_from_hertz)
      fmg::start_from_hertz(climb.hierarchy, l, first_H00(scene), 0);
    else
      throw core::SolverError("Newton's method solved no grid coarse enough to begin on; " + last_reason);
    const bool last_level = l == climb.finest();
    climb.solution.levels.emplace_back();
    const newton::Result result =
        solve_level_by_newton(climb, l, last_level ? final_tolerance(scene) : tolerance_on_the_way);
    // A coarse film that is negative is no solution of the contact, and a good start for the next grid.
    solved = result.equations_met;
    last_reason = name_of_level(climb.hierarchy, l) + ": " + result.reason;
    record(climb, l, 0, state_of_level(climb.hierarchy, l));
    if (last_level) {
      judge(climb);
      climb.solution.converged = climb.solution.converged && result.converged;
      if (!result.converged) climb.solution.failed_check = last_reason;
    }
    climb.solution.levels.back().seconds = core::now() - began;
  }
  return result_of(std::move(climb));
}

}  // namespace ehl::steady
