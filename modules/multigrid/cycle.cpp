#include "multigrid/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "judgement/measures.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/coarse_problem.hpp"
#include "multigrid/relaxation.hpp"

namespace ehl::multigrid {
namespace {

int visits_of_coarsest(Cycle kind, int l) {
  if (kind == Cycle::V || l < 2) return 1;
  return kind == Cycle::W ? 1 << (l - 1) : l;
}

/// A grid that is coarsened along Y alone is corrected once, whatever the cycle: its corrector costs half as much as
/// the grid itself, and one correction is enough. [bench: correct_once]
bool once(const Level& fine, const Level& coarse) { return fine.grid.nx == coarse.grid.nx; }

/// Sum of |r| of the nodes whose pressure may change, over the sum of the transport term, plus the relative defect of
/// the load. (The load is included since a visit that corrects H00 disturbs a residual that was small. A root mean
/// square would see the edge of the contact alone, where a useful visit may raise it.)
double unsolved_share(Hierarchy& hierarchy, Level& level) {
  update_residual(hierarchy, level);
  const core::Patch& grid = level.grid;
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  const reynolds::NodeRows rows = multigrid::rows(hierarchy, level);
  double residual = 0.0, transported = 0.0;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      if (!reynolds::stays_dry(cavitation, level.P(i, j), level.r(i, j))) residual += std::abs(level.r(i, j));
      if (!reynolds::dry(cavitation, level.P(i, j)))
        transported += std::abs(reynolds::transported(rows.wedge(i), rows.Q(i, j)));
    }
  const std::optional<double>& load = hierarchy.problem.load;
  const double missing = load ? std::abs(wanted_load(hierarchy, level) - carried_load(level)) / *load : 0.0;
  return (residual == 0.0 ? 0.0 : residual / transported) +
         missing;  // nothing is transported if all points are cavitated
}

/// Relaxes the coarsest grid. A visit that multiplies what is unsolved is repeated with smaller weights: a new H00 may
/// raise the residual a little, but relaxations that oscillate around the edge of a contact of few cells raise it much
/// more, and then the cycles stall.
void visit_coarsest(Hierarchy& hierarchy, Level& level, int coarsest_sweeps, const Parameters& how) {
  const core::EnclosingTimer timer(hierarchy.times, core::Part::coarsest);
  const double before = unsolved_share(hierarchy, level);
  core::copy(level.P, level.correction);  // a copy; this field is free until the correction is made
  const double H00 = hierarchy.H00;
  const Tuning& tuning = hierarchy.parameters.tuning;
  const double back_off = tuning.back_off;
  Parameters used = how;
  for (;;) {
    used.relaxation = lighter(how.relaxation, hierarchy.coarsest_weight);
    relax_with_force_balance(hierarchy, level, coarsest_sweeps, used);
    const bool oscillates = !(unsolved_share(hierarchy, level) <= tuning.coarsest_raised * before);
    if (!oscillates || hierarchy.coarsest_weight * back_off < tuning.least_all) return;
    hierarchy.coarsest_weight *= back_off;
    core::copy(level.correction, level.P);
    hierarchy.H00 = H00;
    follow_H00(hierarchy, level);
    update_film(hierarchy, level);
  }
}

void cycle(Hierarchy& hierarchy, Level& level, Cycle kind, int coarsest_sweeps, const Parameters& how) {
  Level* const corrector = corrector_of(hierarchy, level);
  if (corrector == nullptr) return visit_coarsest(hierarchy, level, coarsest_sweeps, how);
  Level& coarse = *corrector;
  for (int sweep = 0; sweep < how.pre.value_or(2); ++sweep) relax(hierarchy, level, how.relaxation);

  restrict_problem(hierarchy, level, coarse);
  cycle(hierarchy, coarse, kind, coarsest_sweeps, how);
  const bool again = corrector_of(hierarchy, coarse) != nullptr && !once(level, coarse);
  if (kind == Cycle::W && again) cycle(hierarchy, coarse, Cycle::W, coarsest_sweeps, how);
  if (kind == Cycle::F && again) cycle(hierarchy, coarse, Cycle::V, coarsest_sweeps, how);
  correct_from_coarse(hierarchy, coarse, level, how.weighted_corrections);
  for (int sweep = 0; sweep < how.post.value_or(1); ++sweep) relax(hierarchy, level, how.relaxation);
}

}  // namespace

void fas_cycle(Hierarchy& hierarchy, std::size_t l, const Parameters& how) {
  const Cycle kind = how.cycle.value_or(Cycle::W);
  Level& level = hierarchy.levels[l];
  int below = 0;  // grids that are corrected as often as the kind of cycle demands
  const Level* coarsest = &level;
  while (const Level* next = corrector_of(hierarchy, *coarsest)) {
    if (!once(*coarsest, *next)) ++below;
    coarsest = next;
  }
  // With fewer relaxations in all visits together the force balance lags behind.
  const Tuning& tuning = hierarchy.parameters.tuning;
  const int per_visit =
      std::max(how.coarsest_sweeps, tuning.coarsest_sweeps_per_cycle / visits_of_coarsest(kind, below));
  // The smoothest pressure needs a number of relaxations that grows with the square of the cells. On stretched cells
  // lines along X are solved exactly, and the smoothest pressure of a long inlet varies along Y.
  const double more = level.corrector.between ? coarsest->grid.domain.ny / tuning.coarsest_lines
                                              : coarsest->grid.nx / tuning.coarsest_cells;
  const double finer = std::max(1.0, more);
  cycle(hierarchy, level, kind, static_cast<int>(std::lround(per_visit * finer * finer)), how);
}

void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps, const Parameters& how) {
  // Eq. (26) with the load at the new H00, where the load depends on H00.
  const double c = how.load_relaxation;
  const double share = c / (1.0 + c * (hierarchy.load_line.slope + hierarchy.outside_line.slope));
  // The pressure of a thick film reacts late, and without a limit H00 falls until the bodies meet.
  const double Hc = judgement::value_at(level.grid, level.H, 0.0, 0.0);
  const double fall = hierarchy.parameters.tuning.largest_fall * Hc;
  const double least_H00 = Hc > 0.0 ? hierarchy.H00 - fall : -std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    relax_pressure(hierarchy, level, how.relaxation);
    if (hierarchy.problem.load) {
      hierarchy.H00 -= share * (wanted_load(hierarchy, level) - carried_load(level));
      hierarchy.H00 = std::max(hierarchy.H00, least_H00);
    }
    follow_H00(hierarchy, level);
    update_film(hierarchy, level);
  }
}

}  // namespace ehl::multigrid
