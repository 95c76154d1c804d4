#include "steady/rescue.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "fmg/oil.hpp"
#include "fmg/start.hpp"
#include "judgement/stopping.hpp"
#include "newton/solve.hpp"
#include "steady/resolution.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

/// Relative residual on the grids below the finest: far below their discretization error.
constexpr double tolerance_on_the_way = 1e-6;
constexpr double tolerance_at_rounding = 1e-11;
/// Residual below which a stalled iteration counts as solved to rounding. [bench: tolerance_of_rounding]
constexpr double tolerance_of_rounding = 1e-9;
/// Most cells of a start from the Hertz pressure: the number of Newton steps grows with the number of cells.
constexpr int finest_from_hertz = 128;
/// Number of coarser grids that the estimate of the discretization error needs.
constexpr std::size_t levels_of_an_estimate = 2;

double final_tolerance(const Scene& scene) {
  // fmin() ignores a tolerance that is NaN.
  return std::fmin(tolerance_at_rounding, scene.multigrid.tolerance);
}

// Newton's method on level l, with its row in the table of levels.
newton::Result solve_level_by_newton(fmg::Run& run, std::size_t l, double tolerance) {
  const judgement::Measures start = fmg::measures_of(run.hierarchy, l);
  int steps = 0;
  const newton::Progress progress = [&](const newton::Step& step) {
    judgement::Measures now = start;
    now.residual = step.residual;
    fmg::report(run, l, ++steps, newton::Parameters{}.max_steps, now);
    return true;
  };
  const double of_rounding = std::fmin(tolerance_of_rounding, run.hierarchy.parameters.tolerance);
  return newton::solve(run.hierarchy, l, {.tolerance = tolerance, .tolerance_of_rounding = of_rounding}, progress);
}

// Checks the state of the finest grid after Newton's method; its algebraic error is estimated from the residual, as
// there is no last cycle.
void judge(fmg::Run& run) {
  const std::size_t l = run.finest();
  fmg::Record& record = run.record;
  judgement::Measures now = fmg::measures_of(run.hierarchy, l);
  if (!judgement::unmet_oil(now).empty() && fmg::balance_oil(run.hierarchy, run.hierarchy.finest()))
    now = fmg::measures_of(run.hierarchy, l);
  fmg::enter(run.hierarchy, l, record.levels.back().cycles, now, record);
  fmg::observe(run, l);
  const judgement::LastCycle last{now, now, record.levels.back().error_Hc, record.levels.back().error_Hm};
  record.verification = judgement::verification_of(last);
  const double asked = run.hierarchy.parameters.tolerance;
  const double tolerance = std::isfinite(asked) ? asked : tolerance_on_the_way;
  std::string unmet = judgement::unmet_check(last, tolerance);
  if (unmet.empty()) unmet = judgement::unmet_oil(now);
  record.failed_check = unmet.empty() ? unmet : fmg::name_of_level(run.hierarchy, l) + ": " + unmet;
  record.converged = unmet.empty();
  record.end = unmet.empty()                 ? CyclesEnd::content
               : judgement::no_solution(now) ? CyclesEnd::no_solution
                                             : CyclesEnd::stalled;
}

// Checks the state; if Newton's method did not converge, the solution fails with this reason.
void judge(fmg::Run& run, bool newton_converged, const std::string& reason) {
  judge(run);
  if (newton_converged) return;
  run.record.failed_check = reason;
  run.record.converged = false;
}

// Replaces the table of levels. Coarse states below a finest grid that the cycles did not solve say nothing about its
// discretization error, so the two grids below it are solved again from its solution.
void solve_levels_below(fmg::Run& run) {
  run.record.levels.clear();
  const std::size_t finest = run.finest();
  std::vector<core::Field> injected;  // from level finest - 1 down
  for (std::size_t l = finest; l > run.plan.first && finest - l < levels_of_an_estimate; --l) {
    injected.emplace_back(run.hierarchy.levels[l - 1].grid);
    transfer::restrict_injection(l == finest ? run.hierarchy.finest().P : injected.end()[-2], injected.back());
  }
  const double H00 = run.hierarchy.H00;
  for (std::size_t k = injected.size(); k > 0; --k) {
    fmg::RowTimer timer(run);
    const std::size_t l = finest - k;
    fmg::start_from_state(run.hierarchy, l, {injected[k - 1], H00});
    if (!solve_level_by_newton(run, l, tolerance_on_the_way).converged) {
      run.record.levels.clear();
      continue;
    }
    run.record.levels.emplace_back();
    fmg::enter(run.hierarchy, l, 0, fmg::measures_of(run.hierarchy, l), run.record);
    fmg::observe(run, l);
    timer.stop();
  }
}

}  // namespace

Solution polished(const Scene& scene, fmg::Run&& run) {
  const double began = core::now();
  const bool was_converged = run.record.converged;
  const newton::Result result = solve_level_by_newton(run, run.finest(), final_tolerance(scene));
  if (result.converged || !was_converged) judge(run);
  run.record.levels.back().seconds += core::now() - began;
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  if (!result.converged) solution.polish_failure = result.reason;
  return solution;
}

Solution rescue_by_newton(const Scene& scene, const Start& start, const Solution& unsolved,
                          const ProgressCallback& progress) {
  fmg::Run run = begin_climb(scene, start, progress);
  const std::size_t l = run.finest();
  fmg::Hierarchy& hierarchy = run.hierarchy;
  const double began = core::now();
  run.record.levels = unsolved.levels;
  run.record.history = unsolved.history;
  fmg::start_from_state(hierarchy, l, {core::on_patch(hierarchy.finest().grid, unsolved.P), unsolved.H00});
  const newton::Result result = solve_level_by_newton(run, l, final_tolerance(scene));
  if (result.converged) {
    const fmg::State solved = fmg::state_of(hierarchy, l);
    const core::Field swings = hierarchy.finest().swings;
    solve_levels_below(run);
    run.record.levels.push_back(unsolved.levels.back());
    fmg::start_from_state(hierarchy, l, solved);
    hierarchy.finest().swings = swings;
  }
  judge(run, result.converged, result.reason);
  run.record.levels.back().seconds += core::now() - began;
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  return solution;
}

Solution follow_by_newton(const Scene& scene, const Start& start, const Solution& before,
                          const ProgressCallback& progress) {
  fmg::Run run = begin_climb(scene, start, progress);
  fmg::RowTimer timer(run);
  const std::size_t l = run.finest();
  fmg::start_from_state(run.hierarchy, l, {core::on_patch(run.hierarchy.finest().grid, before.P), before.H00});
  run.record.levels.emplace_back();
  const newton::Result result = solve_level_by_newton(run, l, scene.multigrid.tolerance);
  judge(run, result.converged, result.reason);
  timer.stop();
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  return solution;
}

Solution climb_by_newton(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  fmg::Run run = begin_climb(scene, start, progress);
  bool solved = false;
  std::string last_reason;
  std::vector<newton::Step> steps;
  for (std::size_t l = run.plan.first; l <= run.finest(); ++l) {
    fmg::RowTimer timer(run);
    if (solved)
      fmg::start_from_coarser(run.hierarchy, l);
    else if (run.hierarchy.levels[l].grid.nx <= finest_from_hertz)
      fmg::start_from_hertz(run.hierarchy, l, first_H00(scene), 0);
    else
      throw core::SolverError("the Newton fallback solved no grid that is coarse enough to start from" +
                              (last_reason.empty() ? "" : "; " + last_reason));
    const bool last_level = l == run.finest();
    run.record.levels.emplace_back();
    const newton::Result result =
        solve_level_by_newton(run, l, last_level ? final_tolerance(scene) : tolerance_on_the_way);
    // A negative film on a coarse grid is no solution of the contact, but a good start for the next grid.
    solved = result.equations_met;
    steps = result.steps;
    last_reason = fmg::name_of_level(run.hierarchy, l) + ": " + result.reason;
    fmg::enter(run.hierarchy, l, 0, fmg::measures_of(run.hierarchy, l), run.record);
    fmg::observe(run, l);
    if (last_level) {
      judge(run, result.converged, last_reason);
    }
    timer.stop();
  }
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = std::move(steps);
  return solution;
}

}  // namespace ehl::steady
