#include "multigrid/full_multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "judgement/error_estimate.hpp"
#include "multigrid/cycle_control.hpp"
#include "multigrid/start.hpp"

namespace ehl::multigrid {
namespace {

using judgement::Aim;
using judgement::Measures;
using judgement::StoppingCriterion;

/// The criterion of a level. A meniscus moves by few cells per cycle, and the film in the contact hardly shows it. It
/// reaches its position on the levels below the finest, where cycles are cheap.
StoppingCriterion criterion_of(const Run& run, std::size_t l) {
  const Parameters& parameters = run.hierarchy.parameters;
  const Tuning& tuning = parameters.tuning;
  const int planned = l == run.plan.first ? std::max(run.plan.cycles, parameters.cycles) : parameters.cycles;
  if (l == run.finest())
    return {.aim = Aim::solution,
            .planned = planned,
            .most = std::max(parameters.max_cycles, planned),
            .tolerance = parameters.tolerance};
  const bool meniscus = reynolds::conserves(run.hierarchy.problem.cavitation);
  const double of_start = meniscus ? tuning.meniscus_residual : std::numeric_limits<double>::infinity();
  const int more = meniscus ? tuning.meniscus_cycles * parameters.extra_cycles : 0;
  if (l == run.plan.first)
    return {.aim = Aim::first_start, .planned = planned, .most = planned + more, .of_start = of_start};
  return {.aim = Aim::start,
          .planned = planned,
          .most = planned + (meniscus ? more : parameters.extra_cycles),
          .of_start = of_start};
}

/// Discretization error of the last row. A line contact may start on its finest grid if coarser ones do not resolve its
/// film, and then has no coarser solution to compare with. If the error bound of this mesh alone is at least as large
/// as the film, it is returned instead: such a solution needs no small residual.
DiscretizationError error_known_of(const Run& run, std::size_t l, double Hm) {
  const DiscretizationError known{run.record.levels.back().mesh_error_Hc, run.record.levels.back().mesh_error_Hm};
  const core::Patch& grid = run.hierarchy.levels[l].grid;
  if (l != run.finest() || std::isfinite(known.Hc) || !grid.domain.line) return known;
  const double order = reynolds::order(run.hierarchy.problem.transport.wedge);
  const double bound = judgement::error_of_one_grid(run.hierarchy.parameters.judgement, grid.hx(), Hm, order);
  return bound < 1.0 ? known : DiscretizationError{bound, bound};
}

/// Geometric mean of the convergence factors of the cycles on one level, all but the first.
double mean_factor(const std::vector<double>& residuals) {
  if (residuals.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return std::pow(residuals.back() / residuals.front(), 1.0 / static_cast<double>(residuals.size() - 1));
}

CyclesResult run_cycles(Run& run, std::size_t l, const StoppingCriterion& criterion, const CycleObserver& observe) {
  CyclesResult result = run_cycles(run.hierarchy, l, criterion, run.damping, observe);
  run.damping = result.damping;
  for (const std::string& one : result.remedies) note(one, run.remedies);
  return result;
}

/// The mass-conserving model starts from a flooded solution; the supply is then reduced in steps, and the meniscus
/// recedes with it. [bench: supply_steps]
void reduce_supply(Run& run) {
  Hierarchy& hierarchy = run.hierarchy;
  const Tuning& tuning = hierarchy.parameters.tuning;
  const std::size_t l = run.plan.first;
  Level& level = hierarchy.levels[l];
  const int planned = tuning.cycles_per_supply;
  const StoppingCriterion criterion{.aim = Aim::first_start, .planned = planned, .most = planned};
  const auto cycles = [&] {
    run_cycles(run, l, criterion, [](int, const Measures&) { return DiscretizationError{}; });
  };
  cycles();
  run.damping = run.plan.above;  // damped relaxations keep a meniscus from its position
  const double flooded = measures_of(hierarchy, l).Hc;
  double least = hierarchy.problem.supply(0.0);
  for (int j = 0; j <= level.grid.ny; ++j) least = std::min(least, hierarchy.problem.supply(level.grid.Y(j)));
  least *= share_of_supply(hierarchy, level);
  // Layers that are much thinner than the film pass through unchanged.
  const double thinnest = std::max(least, tuning.thinnest_supply * flooded);
  for (double supply = flooded; supply > thinnest; supply *= tuning.next_supply) {
    hierarchy.least_supply = supply;
    supply_oil(hierarchy, level);
    cycles();
  }
  hierarchy.least_supply = 0.0;
  supply_oil(hierarchy, level);
}

void start_first_level(Run& run, std::size_t l) {
  const Plan& plan = run.plan;
  run.damping = plan.at_first;
  const bool conserves = reynolds::conserves(run.hierarchy.problem.cavitation);
  if (conserves) run.hierarchy.least_supply = std::numeric_limits<double>::infinity();
  start_from_hertz(run.hierarchy, l, plan.H00, plan.sweeps, cautious(run.hierarchy.parameters, run.damping));
  if (conserves) reduce_supply(run);
}

}  // namespace

void for_levels(Run& run, std::size_t from, std::size_t end, const LevelStep& begin, const LevelStep& solve) {
  run.two_below = {};
  for (std::size_t l = from; l < end; ++l) {
    RowTimer timer(run);
    begin(run, l);
    solve(run, l);
    timer.stop();
  }
}

void start_from_below(Run& run, std::size_t l) {
  Hierarchy& hierarchy = run.hierarchy;
  // A coarse solution with a negative film is not extrapolated.
  const bool holds = run.record.levels.back().Hm > 0.0;
  State below = state_of(hierarchy, l - 1);
  if (run.two_below.P.nodes_x() > 0 && holds)
    start_from_two_coarser(hierarchy, l, run.two_below, reynolds::order(hierarchy.problem.transport.wedge));
  else
    start_from_coarser(hierarchy, l);
  run.two_below = holds ? std::move(below) : State{};
}

void full_multigrid(Run& run) {
  const LevelStep begin = [](Run& one, std::size_t l) {
    l == one.plan.first ? start_first_level(one, l) : start_from_below(one, l);
  };
  const LevelStep solve = [](Run& one, std::size_t l) {
    solve_level(one, l);
    if (l == one.plan.first) one.damping = one.plan.above;
  };
  for_levels(run, run.plan.first, run.hierarchy.levels.size(), begin, solve);
}

void solve_level(Run& run, std::size_t l) {
  const StoppingCriterion criterion = criterion_of(run, l);
  Record& record = run.record;
  record.levels.emplace_back();
  std::vector<double> residuals;
  const CycleObserver after_cycle = [&](int cycle, const Measures& now) -> DiscretizationError {
    if (!residuals.empty() && record.history.back().cycle == cycle) {  // again, after the global mass correction
      record.history.pop_back();
      residuals.pop_back();
    }
    enter(run.hierarchy, l, cycle, now, record);
    report(run, l, cycle, criterion.planned, now);
    residuals.push_back(now.residual);
    return error_known_of(run, l, now.Hm);
  };
  const CyclesResult result = run_cycles(run, l, criterion, after_cycle);
  record.verification = verification_of(run.hierarchy.parameters.judgement, result.last);
  const std::string where = name_of_level(run.hierarchy, l) + ": ";
  if (result.end == CyclesEnd::diverged) throw core::SolverError(where + result.unmet);
  record.failed_check = result.unmet.empty() ? "" : where + result.unmet;
  observe(run, l);
  if (l != run.finest()) return;
  record.end = result.end;
  record.cycle_factor = mean_factor(residuals);
  record.converged = record.failed_check.empty();
}

}  // namespace ehl::multigrid
