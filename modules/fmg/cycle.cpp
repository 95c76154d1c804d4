#include "fmg/cycle.hpp"

#include <algorithm>
#include <cmath>

#include "fmg/boundary.hpp"
#include "fmg/coarse_problem.hpp"
#include "fmg/relaxation.hpp"

namespace ehl::fmg {
namespace {

/// Relaxations of the coarsest grid in one cycle, all visits together, below which the force balance lags behind.
constexpr int least_sweeps_per_cycle = 30;

/// Relaxation takes a number of sweeps for the smoothest pressure that grows with the square of the cells; those that
/// are asked for are enough for these. With as many on 48 to 64 cells cycles left 0.6 of the residual.
constexpr double cells_of_coarsest_sweeps = 32.0;

int visits_of_coarsest(Cycle kind, std::size_t l) {
  if (kind == Cycle::V || l < 2) return 1;
  return kind == Cycle::W ? 1 << (l - 1) : static_cast<int>(l);
}

void cycle(Hierarchy& hierarchy, std::size_t l, Cycle kind, int coarsest_sweeps, const Parameters& how) {
  Level& level = hierarchy.levels[l];
  if (l == 0) {
    const core::EnclosingTimer timer(hierarchy.times, core::Part::coarsest);
    relax_with_force_balance(hierarchy, level, coarsest_sweeps, how);
    return;
  }
  for (int sweep = 0; sweep < how.pre; ++sweep) relax(hierarchy, level, how.relaxation);

  restrict_problem(hierarchy, level, hierarchy.levels[l - 1]);
  cycle(hierarchy, l - 1, kind, coarsest_sweeps, how);
  if (kind == Cycle::W && l > 1) cycle(hierarchy, l - 1, Cycle::W, coarsest_sweeps, how);
  if (kind == Cycle::F && l > 1) cycle(hierarchy, l - 1, Cycle::V, coarsest_sweeps, how);
  correct_from_coarse(hierarchy, hierarchy.levels[l - 1], level);

  for (int sweep = 0; sweep < how.post.value_or(1); ++sweep) relax(hierarchy, level, how.relaxation);
}

}  // namespace

void fas_cycle(Hierarchy& hierarchy, std::size_t l, const Parameters& how) {
  const Cycle kind = how.cycle.value_or(Cycle::W);
  const int per_visit = std::max(how.coarsest_sweeps, least_sweeps_per_cycle / visits_of_coarsest(kind, l));
  const double finer = std::max(1.0, hierarchy.levels[0].grid.nx / cells_of_coarsest_sweeps);
  cycle(hierarchy, l, kind, static_cast<int>(std::lround(per_visit * finer * finer)), how);
}

void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps, const Parameters& how) {
  // Where the load itself answers to H00, c is the share of that answer that is left to the pressure.
  const double c = how.load_relaxation;
  const double share = c / (1.0 + c * (hierarchy.load_line.slope + hierarchy.outside_line.slope));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    relax_pressure(hierarchy, level, how.relaxation);
    if (hierarchy.problem.load) hierarchy.H00 -= share * (wanted_load(hierarchy, level) - carried_load(level));
    follow_H00(hierarchy, level);
    update_film(hierarchy, level);
  }
}

}  // namespace ehl::fmg
