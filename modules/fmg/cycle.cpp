#include "fmg/cycle.hpp"

#include <algorithm>

#include "fmg/coarse_problem.hpp"
#include "fmg/relaxation.hpp"

namespace ehl::fmg {
namespace {

/// Relaxations of the coarsest grid in one cycle, all visits together, below which the force balance lags behind.
constexpr int least_sweeps_per_cycle = 30;

int visits_of_coarsest(Cycle kind, std::size_t l) {
  if (kind == Cycle::V || l < 2) return 1;
  return kind == Cycle::W ? 1 << (l - 1) : static_cast<int>(l);
}

void cycle(Hierarchy& hierarchy, std::size_t l, Cycle kind, int coarsest_sweeps) {
  Level& level = hierarchy.levels[l];
  const Parameters& parameters = hierarchy.parameters;
  if (l == 0) {
    const core::EnclosingTimer timer(hierarchy.times, core::Part::coarsest);
    relax_with_force_balance(hierarchy, level, coarsest_sweeps);
    return;
  }
  for (int sweep = 0; sweep < parameters.pre; ++sweep) relax(hierarchy, level);

  restrict_problem(hierarchy, level, hierarchy.levels[l - 1]);
  cycle(hierarchy, l - 1, kind, coarsest_sweeps);
  if (kind == Cycle::W && l > 1) cycle(hierarchy, l - 1, Cycle::W, coarsest_sweeps);
  if (kind == Cycle::F && l > 1) cycle(hierarchy, l - 1, Cycle::V, coarsest_sweeps);
  correct_from_coarse(hierarchy, hierarchy.levels[l - 1], level);

  for (int sweep = 0; sweep < parameters.post.value_or(1); ++sweep) relax(hierarchy, level);
}

}  // namespace

void fas_cycle(Hierarchy& hierarchy, std::size_t l) {
  const Parameters& parameters = hierarchy.parameters;
  const Cycle kind = parameters.cycle.value_or(Cycle::W);
  const int per_visit = least_sweeps_per_cycle / visits_of_coarsest(kind, l);
  cycle(hierarchy, l, kind, std::max(parameters.coarsest_sweeps, per_visit));
}

void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps) {
  // Where the load itself answers to H00, c is the share of that answer that is left to the pressure.
  const double c = hierarchy.parameters.load_relaxation;
  const double share = c / (1.0 + c * hierarchy.load_line.slope);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    relax_pressure(hierarchy, level);
    if (hierarchy.problem.load) hierarchy.H00 -= share * (wanted_load(hierarchy, level) - carried_load(level));
    update_film(hierarchy, level);
  }
}

}  // namespace ehl::fmg
