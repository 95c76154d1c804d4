#include "multigrid/cycle_control.hpp"

#include <algorithm>
#include <utility>

#include "multigrid/across_relaxation.hpp"
#include "multigrid/chattering.hpp"

namespace ehl::multigrid {
namespace {

/// Cycles with a residual near rounding are not judged by their convergence factor.
constexpr double rounding_residual = 1e-10;

/// Number of nodes that are not full in the mass-conserving cavitation model; 0 in the others.
int nodes_not_full(const Hierarchy& hierarchy, const Level& level) {
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  int count = 0;
  if (!reynolds::conserves(cavitation)) return count;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) count += reynolds::dry(cavitation, level.P(i, j)) ? 1 : 0;
  return count;
}

void choose_weights(CycleSeries& series) {
  series.how = cautious(series.hierarchy.parameters, series.damping);
  series.how.relaxation.weight_single_steep *= series.growth;
  series.how.relaxation.across = series.across;
}

/// The residual `cycles` before the last one, since the last change.
double residual_before(const CycleSeries& series, int cycles) {
  return series.residuals[series.residuals.size() - 1 - static_cast<std::size_t>(cycles)];
}
int cycles_since_change(const CycleSeries& series) { return static_cast<int>(series.residuals.size()); }

// ---- Conditions

bool slow_without_relaxation_after(const CycleSeries& series) {
  return slow(series) && series.now.residual > rounding_residual && series.how.post == 0;
}

bool slow_without_y_sweep(const CycleSeries& series) {
  return slow(series) && series.now.residual > rounding_residual && !series.across &&
         !core::stretched(series.level().grid) && can_relax_across(series.hierarchy, series.level());
}

/// The residual does not even halve in some cycles.
bool stalled(const CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  return cycles_since_change(series) > tuning.patience &&
         series.now.residual > tuning.hardly_less * residual_before(series, tuning.patience);
}

/// The residual exceeds a share both of that one cycle before and of that two cycles before. The first cycles after a
/// change still feel the interpolation.
bool poor(const CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  return cycles_since_change(series) > 2 && series.now.residual > tuning.poor_factor * series.before.residual &&
         series.now.residual > tuning.poor_factor * residual_before(series, 2) &&
         series.now.residual > rounding_residual;
}

/// Damping does not cure chattering nodes.
bool may_have_chattering_nodes(const CycleSeries& series) {
  return (poor(series) || stalled(series) || series.flips) && series.criterion.aim == judgement::Aim::solution &&
         series.now.residual > rounding_residual;
}

bool on_stretched_cells(const CycleSeries& series) { return core::stretched(series.level().grid) && series.cycles > 1; }

// ---- Changes

enum class Change { none, made, end };

Change relax_after(CycleSeries& series) {
  series.damping.relax_after = true;
  choose_weights(series);
  series.residuals = {series.now.residual};
  return Change::made;
}

Change sweep_across(CycleSeries& series) {
  series.across = true;
  series.damping.weighted |= series.criterion.aim != judgement::Aim::first_start;
  choose_weights(series);
  series.residuals = {series.now.residual};
  return Change::made;
}

Change mark_chattering_nodes(CycleSeries& series) {
  if (find_chattering(series.hierarchy, series.level(), series.how.relaxation) == 0) return Change::none;
  series.now = measures_of(series.hierarchy, series.l);
  series.residuals = {series.now.residual};
  return Change::made;
}

Change end_the_series(CycleSeries&) { return Change::end; }

/// Increases the damping by one step, first where epsilon is steep.
Change back_off(CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  Damping& damping = series.damping;
  if (damping.steep * tuning.back_off >= tuning.least_steep)
    damping.steep *= tuning.back_off;
  else if (damping.all * tuning.back_off >= tuning.least_all)
    damping.all *= tuning.back_off;
  else
    return Change::none;
  choose_weights(series);
  series.residuals = {series.before.residual, series.now.residual};
  return Change::made;
}

Change follow_growth(CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  const double before = series.growth;
  const double factor = series.now.residual / series.before.residual;
  if (factor > tuning.poor_factor)
    series.growth = 1.0, series.grows = false;
  else if (series.grows && factor < tuning.good_factor)
    series.growth = std::min(tuning.growth_limit, series.growth * tuning.growth_per_cycle);
  choose_weights(series);
  return series.growth > before ? Change::made : Change::none;
}

// ---- The table. After every cycle the rules are asked in this order; in each group the first one that changes
// something is the last one asked.

enum class Group { slow, no_better, fast };

struct Rule {
  Group group;
  const char* name;
  bool (*when)(const CycleSeries& series);
  Change (*change)(CycleSeries& series);
};

constexpr Rule rules[] = {
    // [bench: rough_factor, y_sweep, weighted_interpolation]
    {Group::slow, "relaxation after the correction", slow_without_relaxation_after, relax_after},
    {Group::slow, "Y sweep", slow_without_y_sweep, sweep_across},
    // [bench: chattering_residuals, cycles_patience, poor_factor, back_off]
    {Group::no_better, "first-order flux of chattering nodes", may_have_chattering_nodes, mark_chattering_nodes},
    {Group::no_better, "end", stalled, end_the_series},
    {Group::no_better, "damping", poor, back_off},
    // [bench: steep_weight_growth]
    {Group::fast, "growth of the steep weight", on_stretched_cells, follow_growth},
};

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

CycleSeries begin_series(Hierarchy& hierarchy, std::size_t l, const judgement::StoppingCriterion& criterion,
                         const Damping& damping) {
  CycleSeries series{.hierarchy = hierarchy, .l = l, .criterion = criterion, .damping = damping};
  series.across = hierarchy.parameters.relaxation.across;
  series.start = state_of(hierarchy, l);
  series.before = measures_of(hierarchy, l);
  series.not_full = series.not_full_before = nodes_not_full(hierarchy, series.level());
  choose_weights(series);
  return series;
}

bool slow(const CycleSeries& series) {
  return series.cycles > 1 && series.now.residual > series.tuning().rough_factor * series.before.residual;
}

bool restart(CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  if (series.damping.all * tuning.back_off < tuning.least_all) return false;
  series.damping.all *= tuning.back_off;
  if (series.how.post == 0) series.damping.relax_after = true;
  series.growth = 1.0;
  series.grows = false;
  choose_weights(series);
  series.residuals.clear();
  series.before = measures_of(series.hierarchy, series.l);
  note("restart with damping", series.remedies);
  return true;
}

void note_cycle(CycleSeries& series) {
  const Tuning& tuning = series.tuning();
  series.residuals.push_back(series.now.residual);
  const int count = nodes_not_full(series.hierarchy, series.level());
  series.flips = count != series.not_full && count == series.not_full_before &&
                 series.now.residual > tuning.poor_factor * series.two_before;
  // A meniscus that moves is not judged by its residuals.
  if (count != series.not_full && !series.flips && series.cycles <= tuning.meniscus_moves)
    series.residuals = {series.now.residual};
  series.not_full_before = std::exchange(series.not_full, count);
  series.two_before = series.before.residual;
}

bool follow_rules(CycleSeries& series) {
  const Rule* last = nullptr;  // that changed something
  for (const Rule& rule : rules) {
    if ((last != nullptr && last->group == rule.group) || !rule.when(series)) continue;
    const Change change = rule.change(series);
    if (change == Change::end) return false;
    if (change == Change::none) continue;
    note(rule.name, series.remedies);
    last = &rule;
  }
  return true;
}

void note(const std::string& name, std::vector<std::string>& list) {
  if (std::ranges::find(list, name) == list.end()) list.push_back(name);
}

}  // namespace ehl::multigrid
