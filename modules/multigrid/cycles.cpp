#include "multigrid/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Relative residual from which cycles do not recover.
constexpr double hopeless_residual = 1e3;
/// Cycles stall if the residual does not even halve (hardly_less) in this many of them since the last change of
/// damping.
constexpr int patience = 6;
constexpr double hardly_less = 0.5;
/// A poor cycle asks for more damping: its residual exceeds this share both of the residual one cycle before and of
/// that two cycles before. The first settling_cycles after a change still feel the interpolation and do not count, nor
/// do residuals near rounding.
constexpr double poor_factor = 0.75;
constexpr int settling_cycles = 2;
constexpr double rounding_residual = 1e-10;
constexpr double back_off_steep = 0.8;
constexpr double least_steep = 0.6;
constexpr double back_off_all = 0.8;
constexpr double least_all = 0.5;

/// Growth of the steep weight on stretched cells, which is small at first for states far from the solution: the
/// convergence factor below which a cycle multiplies the weight, the multiplier, and its limit. The first poor cycle
/// ends the growth for good, since weights that rise and fall spoil the Krylov acceleration.
/// [bench: steep_weight_growth]
constexpr double good_factor = 0.6;
constexpr double growth_per_cycle = 1.25;
constexpr double growth_limit = 1.4;

/// During this many cycles a meniscus may still be moving to its position, which does not call for more damping.
constexpr int on_its_way = 15;

/// Number of nodes that are not full in the mass-conserving cavitation model; 0 in the others.
int dry_nodes(const Level& level, reynolds::Cavitation cavitation) {
  int count = 0;
  if (!reynolds::conserves(cavitation)) return count;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) count += reynolds::dry(cavitation, level.P(i, j)) ? 1 : 0;
  return count;
}

/// Increases the damping by one step; false if it is at its limit.
bool back_off(Damping& damping) {
  if (damping.steep * back_off_steep >= least_steep)
    damping.steep *= back_off_steep;
  else if (damping.all * back_off_all >= least_all)
    damping.all *= back_off_all;
  else
    return false;
  return true;
}

/// Growth factor of the steep weight on stretched cells.
struct WeightGrowth {
  double factor = 1.0;
  bool rises = true;

  void end() { *this = {.factor = 1.0, .rises = false}; }

  void behind_cycle(double left) {
    if (left > poor_factor)
      end();
    else if (rises && left < good_factor)
      factor = std::min(growth_limit, factor * growth_per_cycle);
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
  return now.residual < hopeless_residual && std::isfinite(now.Hc) ? "" : "the cycles diverge";
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
  if (verdict.unmet.empty()) verdict.unmet = judgement::unmet_oil(now);
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
      if (needed.all * back_off_all < least_all) return result;
      needed.all *= back_off_all;
      if (how.post == 0) needed.relax_after = true;
      growth.end();
      more_careful({});
      before = measures_of(hierarchy, l);
      continue;
    }
    accelerates |= result.cycles > 1 && now.residual > rough_factor * before.residual &&
                   can_relax_across(hierarchy, hierarchy.levels[l]);
    if (accelerates) accelerate(hierarchy, l, states, now);
    const auto look = [&] {
      const DiscretizationError error = observe(result.cycles, now);
      result.last = {before, now, error.Hc, error.Hm, result.cycles == 1};
      return judged(criterion, result.cycles, result.last);
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
    const bool to_and_fro = count != dry && count == dry_before && now.residual > poor_factor * two_before;
    if (count != dry && !to_and_fro && result.cycles <= on_its_way) residuals = {now.residual};
    dry_before = std::exchange(dry, count);
    two_before = before.residual;
    const bool rough =
        result.cycles > 1 && now.residual > rough_factor * before.residual && now.residual > rounding_residual;
    if (rough && how.post == 0) {
      needed.relax_after = true;
      more_careful({now.residual});
    } else if (rough && !across && !stretched && can_relax_across(hierarchy, hierarchy.levels[l])) {
      across = true;
      needed.weighted |= criterion.aim != judgement::Aim::first_start;
      more_careful({now.residual});
    }
    const std::size_t taken = residuals.size();
    const bool stalled = taken > patience && now.residual > hardly_less * residuals[taken - 1 - patience];
    const bool poor = taken > settling_cycles && now.residual > poor_factor * before.residual &&
                      now.residual > poor_factor * residuals[taken - 3] && now.residual > rounding_residual;
    const bool chatters = (poor || stalled || to_and_fro) && criterion.aim == judgement::Aim::solution &&
                          may_chatter(now.residual) &&
                          find_chattering(hierarchy, hierarchy.levels[l], how.relaxation) > 0;
    if (chatters) {  // damping does not cure chattering nodes
      now = measures_of(hierarchy, l);
      residuals = {now.residual};
    } else if (stalled) {
      result.end = CyclesEnd::stalled;
      return result;
    } else if (poor && back_off(needed)) {
      more_careful({before.residual, now.residual});
    }
    if (stretched && result.cycles > 1) {
      growth.behind_cycle(now.residual / before.residual);
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
