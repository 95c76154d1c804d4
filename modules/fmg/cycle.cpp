#include "fmg/cycle.hpp"

#include "fmg/coarse_problem.hpp"
#include "fmg/relaxation.hpp"

namespace ehl::fmg {
namespace {

void cycle(Hierarchy& hierarchy, std::size_t l, Cycle kind) {
  Level& level = hierarchy.levels[l];
  const Parameters& parameters = hierarchy.parameters;
  if (l == 0) {
    const core::PartTimes before = hierarchy.times;
    const double start = core::now();
    relax_with_force_balance(hierarchy, level, parameters.coarsest_sweeps);
    hierarchy.times = before;  // the coarsest grid is one part of its own
    hierarchy.times[core::Part::coarsest] += core::now() - start;
    return;
  }
  for (int sweep = 0; sweep < parameters.pre; ++sweep) relax(hierarchy, level);

  restrict_problem(hierarchy, level, hierarchy.levels[l - 1]);
  cycle(hierarchy, l - 1, kind);
  if (kind == Cycle::W && l > 1) cycle(hierarchy, l - 1, Cycle::W);
  if (kind == Cycle::F && l > 1) cycle(hierarchy, l - 1, Cycle::V);
  correct_from_coarse(hierarchy, hierarchy.levels[l - 1], level);

  for (int sweep = 0; sweep < parameters.post; ++sweep) relax(hierarchy, level);
}

}  // namespace

void fas_cycle(Hierarchy& hierarchy, std::size_t l) { cycle(hierarchy, l, hierarchy.parameters.cycle); }

void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    relax(hierarchy, level);
    if (!hierarchy.problem.load) continue;
    const double change = -hierarchy.parameters.load_relaxation * (level.load - carried_load(level));
    hierarchy.H00 += change;
    shift_film(hierarchy, level, change);
  }
}

}  // namespace ehl::fmg
