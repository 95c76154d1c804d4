#include "multigrid/cycles.hpp"

#include <cmath>
#include <utility>

#include "core/errors.hpp"
#include "multigrid/acceleration.hpp"
#include "multigrid/across_relaxation.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/cycle_control.hpp"
#include "multigrid/mass_balance.hpp"

namespace ehl::multigrid {
namespace {

void go_back(Hierarchy& hierarchy, std::size_t l, const State& state) {
  hierarchy.levels[l].P = state.P;
  hierarchy.H00 = state.H00;
  update_film(hierarchy, hierarchy.levels[l]);
  renew_boundary(hierarchy, hierarchy.levels[l]);
}

// One cycle, then the boundary and the measures of the new state. out: how it diverged; empty if it did not.
std::string cycle(Hierarchy& hierarchy, std::size_t l, const Parameters& how, judgement::Measures& now) {
  try {
    fas_cycle(hierarchy, l, how);
    renew_boundary_and_inside(hierarchy, hierarchy.levels[l]);
    now = measures_of(hierarchy, l);
  } catch (const core::SolverError& error) {
    return error.what();
  }
  return now.residual < hierarchy.parameters.tuning.hopeless_residual && std::isfinite(now.Hc) ? ""
                                                                                               : "the cycles diverge";
}

// Krylov acceleration: takes the combination with the earlier states if it has the smaller residual.
void accelerate(Hierarchy& hierarchy, std::size_t l, Acceleration& before, judgement::Measures& now) {
  State combined;
  if (before.combine(hierarchy, l, combined)) {
    const State plain = state_of(hierarchy, l);
    const double residual = now.residual;
    go_back(hierarchy, l, combined);
    now = measures_of(hierarchy, l);
    if (!(now.residual < residual)) {
      go_back(hierarchy, l, plain);
      now = measures_of(hierarchy, l);
    }
  }
  before.remember(hierarchy, l);
}

}  // namespace

judgement::Verdict close_or_leave(Hierarchy& hierarchy, std::size_t l, const State& before,
                                  const RelaxationParameters& relaxation, judgement::Measures& now,
                                  const std::function<judgement::Verdict()>& judge) {
  const auto look = [&] {
    now = measures_of(hierarchy, l);
    return judge();
  };
  const State unclosed = state_of(hierarchy, l);
  const bool closed = correct_mass(hierarchy, hierarchy.levels[l], before, relaxation);
  judgement::Verdict verdict;
  if (closed) verdict = look();
  if (verdict.unmet.empty()) verdict.unmet = judgement::unmet_oil(hierarchy.parameters.judgement, now);
  // A correction that fails leaves rough errors, which would make the next one fail again.
  if (closed && !verdict.unmet.empty()) {
    go_back(hierarchy, l, unclosed);
    look();
  }
  return verdict;
}

CyclesResult run_cycles(Hierarchy& hierarchy, std::size_t l, const judgement::StoppingCriterion& criterion,
                        const Damping& damping, const CycleObserver& observe) {
  hierarchy.coarsest_weight = 1.0;
  CycleSeries series = begin_series(hierarchy, l, criterion, damping);
  CyclesResult result{.end = CyclesEnd::limit};
  const auto judge = [&] {
    const DiscretizationError error = observe(series.cycles, series.now);
    result.last = {series.before, series.now, error.Hc, error.Hm};
    return judged(hierarchy.parameters.judgement, criterion, series.cycles, result.last);
  };
  const bool closes = criterion.aim == judgement::Aim::solution && conserves_mass(hierarchy.levels[l]);
  Acceleration states;
  bool accelerates = false;
  State last;
  while (result.end == CyclesEnd::limit && series.cycles < criterion.most) {
    ++series.cycles;
    if (closes) last = state_of(hierarchy, l);
    result.unmet = cycle(hierarchy, l, series.how, series.now);
    if (!result.unmet.empty()) {
      go_back(hierarchy, l, series.start);
      states.forget();
      if (!restart(series)) result.end = CyclesEnd::diverged;
      continue;
    }
    accelerates |= slow(series) && can_relax_across(hierarchy, hierarchy.levels[l]);
    if (accelerates) accelerate(hierarchy, l, states, series.now);
    judgement::Verdict verdict = judge();
    if (verdict.unmet.empty() && closes)
      verdict = close_or_leave(hierarchy, l, last, series.how.relaxation, series.now, judge);
    result.unmet = verdict.unmet;
    if (result.unmet.empty() || verdict.no_solution) {
      result.end = verdict.no_solution ? CyclesEnd::no_solution : CyclesEnd::converged;
      continue;
    }
    note_cycle(series);
    if (!follow_rules(series)) result.end = CyclesEnd::stalled;
    series.before = series.now;
  }
  if (accelerates) note("Krylov acceleration", series.remedies);
  result.cycles = series.cycles;
  result.damping = series.damping;
  result.remedies = std::move(series.remedies);
  return result;
}

judgement::Measures measures_of(Hierarchy& hierarchy, std::size_t l) {
  const core::EnclosingTimer timer(hierarchy.times, core::Part::checks);
  Level& level = hierarchy.levels[l];
  update_residual(hierarchy, level);
  return judgement::measures({.grid = level.grid,
                              .fields = fields(level),
                              .r = level.r,
                              .transport = hierarchy.transport,
                              .cavitation = hierarchy.problem.cavitation,
                              .outline = hierarchy.problem.geometry.outline,
                              .carried = carried_load(level),
                              .wanted = level.load,
                              .on_bodies = pressure_on_bodies(level)});
}

}  // namespace ehl::multigrid
