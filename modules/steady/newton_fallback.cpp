#include "steady/newton_fallback.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "core/timer.hpp"
#include "judgement/stopping.hpp"
#include "multigrid/mass_balance.hpp"
#include "multigrid/start.hpp"
#include "newton/solve.hpp"
#include "transfer/transfer.hpp"

namespace ehl::steady {
namespace {

constexpr double tolerance_at_rounding = 1e-11;
/// Residual below which a stalled iteration counts as solved to rounding. [bench: tolerance_of_rounding]
constexpr double tolerance_of_rounding = 1e-9;
/// Number of coarser grids that the estimate of the discretization error needs.
constexpr std::size_t levels_of_an_estimate = 2;

// Checks the state of the finest grid after Newton's method; its algebraic error is estimated from the residual, as
// there is no last cycle.
void judge(const Scene& scene, multigrid::Run& run) {
  const std::size_t l = run.finest();
  const judgement::Tuning& tuning = run.hierarchy.parameters.judgement;
  multigrid::Record& record = run.record;
  judgement::Measures now = multigrid::measures_of(run.hierarchy, l);
  if (!judgement::unmet_oil(tuning, now).empty() && multigrid::balance_mass(run.hierarchy, run.hierarchy.finest()))
    now = multigrid::measures_of(run.hierarchy, l);
  multigrid::enter(run.hierarchy, l, record.levels.back().cycles, now, record);
  multigrid::observe(run, l);
  const judgement::LastCycle last{now, now, record.levels.back().mesh_error_Hc, record.levels.back().mesh_error_Hm};
  record.verification = judgement::verification_of(tuning, last);
  const double asked = run.hierarchy.parameters.tolerance;
  const double tolerance = std::isfinite(asked) ? asked : scene.solver.judgement.default_tolerance;
  std::string unmet = judgement::unmet_check(tuning, last, tolerance);
  if (unmet.empty()) unmet = judgement::unmet_oil(tuning, now);
  record.failed_check = unmet.empty() ? unmet : multigrid::name_of_level(run.hierarchy, l) + ": " + unmet;
  record.converged = unmet.empty();
  record.end = unmet.empty()                         ? CyclesEnd::converged
               : judgement::no_solution(tuning, now) ? CyclesEnd::no_solution
                                                     : CyclesEnd::stalled;
}

}  // namespace

double final_tolerance(const Scene& scene) {
  // fmin() ignores a tolerance that is NaN.
  return std::fmin(tolerance_at_rounding, scene.solver.tolerance);
}

newton::Result solve_level_by_newton(const Scene& scene, multigrid::Run& run, std::size_t l, double tolerance,
                                     int max_steps) {
  const judgement::Measures start = multigrid::measures_of(run.hierarchy, l);
  int steps = 0;
  const newton::Progress progress = [&](const newton::Step& step) {
    judgement::Measures now = start;
    now.residual = step.residual;
    multigrid::report(run, l, ++steps, max_steps, now);
    return true;
  };
  const double of_rounding = std::fmin(tolerance_of_rounding, run.hierarchy.parameters.tolerance);
  return newton::solve(
      run.hierarchy, l,
      {.tolerance = tolerance, .tolerance_of_rounding = of_rounding, .max_steps = max_steps, .tuning = scene.newton},
      progress);
}

void judge_newton(const Scene& scene, multigrid::Run& run, bool newton_converged, const std::string& reason) {
  judge(scene, run);
  if (newton_converged) return;
  run.record.failed_check = reason;
  run.record.converged = false;
}

namespace {

// Replaces the table of levels. Coarse states below a finest grid that the cycles did not solve say nothing about its
// discretization error, so the two grids below it are solved again from its solution.
void solve_levels_below(const Scene& scene, multigrid::Run& run) {
  run.record.levels.clear();
  const std::size_t finest = run.finest();
  std::vector<core::Field> injected;  // from level finest - 1 down
  for (std::size_t l = finest; l > run.plan.first && finest - l < levels_of_an_estimate; --l) {
    injected.emplace_back(run.hierarchy.levels[l - 1].grid);
    transfer::restrict_injection(l == finest ? run.hierarchy.finest().P : injected.end()[-2], injected.back());
  }
  const double H00 = run.hierarchy.H00;
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t l) {
    multigrid::start_from_state(run.hierarchy, l, {injected[finest - l - 1], H00});
  };
  const multigrid::LevelStep solve = [&](multigrid::Run&, std::size_t l) {
    if (!solve_level_by_newton(scene, run, l, scene.solver.judgement.default_tolerance).converged)
      return run.record.levels.clear();
    run.record.levels.emplace_back();
    multigrid::enter(run.hierarchy, l, 0, multigrid::measures_of(run.hierarchy, l), run.record);
    multigrid::observe(run, l);
  };
  multigrid::for_levels(run, finest - injected.size(), finest, begin, solve);
}

}  // namespace

Solution polished(const Scene& scene, multigrid::Run&& run) {
  const double began = core::now();
  const bool was_converged = run.record.converged;
  const newton::Result result = solve_level_by_newton(scene, run, run.finest(), final_tolerance(scene));
  if (result.converged || !was_converged) judge(scene, run);
  run.record.levels.back().seconds += core::now() - began;
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  if (!result.converged) solution.polish_failure = result.reason;
  return solution;
}

Solution refine_by_newton(const Scene& scene, const Start& start, const Solution& unsolved,
                          const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(scene, start, progress);
  const std::size_t l = run.finest();
  multigrid::Hierarchy& hierarchy = run.hierarchy;
  const double began = core::now();
  run.record.levels = unsolved.levels;
  run.record.history = unsolved.history;
  multigrid::start_from_state(hierarchy, l, {core::on_patch(hierarchy.finest().grid, unsolved.P), unsolved.H00});
  const newton::Result result = solve_level_by_newton(scene, run, l, final_tolerance(scene));
  if (result.converged) {
    const multigrid::State solved = multigrid::state_of(hierarchy, l);
    const std::optional<multigrid::OilContent> content = hierarchy.finest().content;
    solve_levels_below(scene, run);
    run.record.levels.push_back(unsolved.levels.back());
    multigrid::start_from_state(hierarchy, l, solved);
    if (content) hierarchy.finest().content->chatters = content->chatters;
  }
  judge_newton(scene, run, result.converged, result.reason);
  run.record.levels.back().seconds += core::now() - began;
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  return solution;
}

Solution follow_by_newton(const Scene& scene, const Start& start, const Solution& before,
                          const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(scene, start, progress);
  newton::Result result{};
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t l) {
    multigrid::start_from_state(run.hierarchy, l, {core::on_patch(run.hierarchy.finest().grid, before.P), before.H00});
  };
  const multigrid::LevelStep solve = [&](multigrid::Run&, std::size_t l) {
    run.record.levels.emplace_back();
    result = solve_level_by_newton(scene, run, l, scene.solver.tolerance);
    judge_newton(scene, run, result.converged, result.reason);
  };
  multigrid::for_levels(run, run.finest(), run.hierarchy.levels.size(), begin, solve);
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = result.steps;
  return solution;
}

Solution solve_by_newton(const Scene& scene, const Start& start, const ProgressCallback& progress) {
  multigrid::Run run = begin_multigrid(scene, start, progress);
  newton::Result last{};
  std::string last_reason;
  const multigrid::LevelStep begin = [&](multigrid::Run&, std::size_t l) {
    // A negative film on a coarse grid is no solution of the contact, but a good start for the next grid.
    if (last.equations_met)
      multigrid::start_from_coarser(run.hierarchy, l);
    else if (run.hierarchy.levels[l].grid.nx <= scene.tuning.finest_from_hertz)
      multigrid::start_from_hertz(run.hierarchy, l, first_H00(scene), 0);
    else
      throw core::SolverError("the Newton fallback solved no grid that is coarse enough to start from" +
                              (last_reason.empty() ? "" : "; " + last_reason));
  };
  const multigrid::LevelStep solve = [&](multigrid::Run&, std::size_t l) {
    const bool last_level = l == run.finest();
    run.record.levels.emplace_back();
    last = solve_level_by_newton(scene, run, l,
                                 last_level ? final_tolerance(scene) : scene.solver.judgement.default_tolerance);
    last_reason = multigrid::name_of_level(run.hierarchy, l) + ": " + last.reason;
    multigrid::enter(run.hierarchy, l, 0, multigrid::measures_of(run.hierarchy, l), run.record);
    multigrid::observe(run, l);
    if (last_level) judge_newton(scene, run, last.converged, last_reason);
  };
  multigrid::for_levels(run, run.plan.first, run.hierarchy.levels.size(), begin, solve);
  Solution solution = solution_of(scene, std::move(run));
  solution.newton = std::move(last.steps);
  return solution;
}

}  // namespace ehl::steady
