#include "multigrid/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "multigrid/acceleration.hpp"
#include "multigrid/across_relaxation.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/chattering.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/mass_balance.hpp"

namespace ehl::multigrid {
namespace {

/// Cycles with a residual near rounding are not judged by their convergence factor.
constexpr double rounding_residual = 1e-10;

/// Number of nodes that are not full in the mass-conserving cavitation model; 0 in the others.
int dry_nodes(const Level& level, reynolds::Cavitation cavitation) {
  int count = 0;
  if (!reynolds::conserves(cavitation)) return count;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) count += reynolds::dry(cavitation, level.P(i, j)) ? 1 : 0;
  return count;
}

/// Increases the damping by one step; false if it is at its limit.
bool back_off(const Tuning& tuning, Damping& damping) {
  if (damping.steep * tuning.back_off_steep >= tuning.least_steep)
    damping.steep *= tuning.back_off_steep;
  else if (damping.all * tuning.back_off_all >= tuning.least_all)
    damping.all *= tuning.back_off_all;
  else
    return false;
  return true;
}

/// Growth factor of the steep weight on stretched cells, which is small at first for states far from the solution. The
/// first poor cycle ends the growth for good, since weights that rise and fall spoil the Krylov acceleration.
struct WeightGrowth {
  double factor = 1.0;
  bool rises = true;

  void end() { *this = {.factor = 1.0, .rises = false}; }

  void behind_cycle(const Tuning& tuning, double left) {
    if (left > tuning.poor_factor)
      end();
    else if (rises && left < tuning.good_factor)
      factor = std::min(tuning.growth_limit, factor * tuning.growth_per_cycle);
  }
};

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

Parameters cautious(const Parameters& parameters, const Damping& damping) {
  Parameters used = parameters;
  used.relaxation = lighter(used.relaxation, damping.all);
  used.relaxation.weight_single_steep *= damping.steep;
  if (damping.weighted) {
    used.weighted_corrections = true;
    if (used.cycle == Cycle::F) used.cycle = Cycle::W;
  }
  if (damping.relax_after) used.post = std::max(1, used.post.value_or(1));
  return used;
}

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
  CyclesResult result{.damping = damping};
  hierarchy.coarsest_weight = 1.0;
  const Tuning& tuning = hierarchy.parameters.tuning;
  Damping& needed = result.damping;
  Parameters how = cautious(hierarchy.parameters, needed);
  const State start = state_of(hierarchy, l);
  judgement::Measures before = measures_of(hierarchy, l);
  std::vector<double> residuals;  // since the last change of damping
  WeightGrowth growth;
  bool across = how.relaxation.across;
  const bool stretched = core::stretched(hierarchy.levels[l].grid);
  const auto choose_weights = [&] {
    how = cautious(hierarchy.parameters, needed);
    how.relaxation.weight_single_steep *= growth.factor;
    how.relaxation.across = across;
  };
  const auto more_careful = [&](std::vector<double> so_far) {
    choose_weights();
    residuals = std::move(so_far);
  };
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  int dry = dry_nodes(hierarchy.levels[l], cavitation), dry_before = dry;
  Acceleration states;
  bool accelerates = false;
  double two_before = std::numeric_limits<double>::infinity();  // residual two cycles before
  const bool closes = criterion.aim == judgement::Aim::solution && conserves_mass(hierarchy.levels[l]);
  State last;
  while (result.cycles < criterion.most) {
    ++result.cycles;
    if (closes) last = state_of(hierarchy, l);
    judgement::Measures now;
    if (const std::string diverged = cycle(hierarchy, l, how, now); !diverged.empty()) {
      go_back(hierarchy, l, start);
      states.forget();
      result.unmet = diverged;
      result.end = CyclesEnd::diverged;
      if (needed.all * tuning.back_off_all < tuning.least_all) return result;
      needed.all *= tuning.back_off_all;
      if (how.post == 0) needed.relax_after = true;
      growth.end();
      more_careful({});
      before = measures_of(hierarchy, l);
      continue;
    }
    accelerates |= result.cycles > 1 && now.residual > tuning.rough_factor * before.residual &&
                   can_relax_across(hierarchy, hierarchy.levels[l]);
    if (accelerates) accelerate(hierarchy, l, states, now);
    const auto look = [&] {
      const DiscretizationError error = observe(result.cycles, now);
      result.last = {before, now, error.Hc, error.Hm, result.cycles == 1};
      return judged(hierarchy.parameters.judgement, criterion, result.cycles, result.last);
    };
    judgement::Verdict verdict = look();
    if (verdict.unmet.empty() && closes) verdict = close_or_leave(hierarchy, l, last, how.relaxation, now, look);
    result.unmet = verdict.unmet;
    if (result.unmet.empty() || verdict.no_solution) {
      result.end = verdict.no_solution ? CyclesEnd::no_solution : CyclesEnd::converged;
      return result;
    }
    residuals.push_back(now.residual);
    const int count = dry_nodes(hierarchy.levels[l], cavitation);
    const bool to_and_fro = count != dry && count == dry_before && now.residual > tuning.poor_factor * two_before;
    if (count != dry && !to_and_fro && result.cycles <= tuning.meniscus_moves) residuals = {now.residual};
    dry_before = std::exchange(dry, count);
    two_before = before.residual;
    const bool rough =
        result.cycles > 1 && now.residual > tuning.rough_factor * before.residual && now.residual > rounding_residual;
    if (rough && how.post == 0) {
      needed.relax_after = true;
      more_careful({now.residual});
    } else if (rough && !across && !stretched && can_relax_across(hierarchy, hierarchy.levels[l])) {
      across = true;
      needed.weighted |= criterion.aim != judgement::Aim::first_start;
      more_careful({now.residual});
    }
    // Stalled: the residual does not even halve in some cycles. Poor: it exceeds a share both of the residual one cycle
    // before and of that two cycles before. The first cycles after a change of damping still feel the interpolation.
    const auto taken = static_cast<int>(residuals.size());
    const auto before_last = [&](int cycles) { return residuals[static_cast<std::size_t>(taken - 1 - cycles)]; };
    const bool stalled = taken > tuning.patience && now.residual > tuning.hardly_less * before_last(tuning.patience);
    const bool poor = taken > std::max(2, tuning.settling_cycles) &&
                      now.residual > tuning.poor_factor * before.residual &&
                      now.residual > tuning.poor_factor * before_last(2) && now.residual > rounding_residual;
    const bool chatters = (poor || stalled || to_and_fro) && criterion.aim == judgement::Aim::solution &&
                          may_chatter(tuning, now.residual) &&
                          find_chattering(hierarchy, hierarchy.levels[l], how.relaxation) > 0;
    if (chatters) {  // damping does not cure chattering nodes
      now = measures_of(hierarchy, l);
      residuals = {now.residual};
    } else if (stalled) {
      result.end = CyclesEnd::stalled;
      return result;
    } else if (poor && back_off(tuning, needed)) {
      more_careful({before.residual, now.residual});
    }
    if (stretched && result.cycles > 1) {
      growth.behind_cycle(tuning, now.residual / before.residual);
      choose_weights();
    }
    before = now;
  }
  result.end = CyclesEnd::limit;
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
                              .wanted = level.load});
}

}  // namespace ehl::multigrid
