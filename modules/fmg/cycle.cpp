#include "fmg/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fmg/boundary.hpp"
#include "fmg/coarse_problem.hpp"
#include "fmg/relaxation.hpp"
#include "judgement/measures.hpp"

namespace ehl::fmg {
namespace {

/// Relaxations of the coarsest grid in one cycle, all visits together, below which the force balance lags behind.
constexpr int least_sweeps_per_cycle = 30;

/// Relaxation takes a number of sweeps for the smoothest pressure that grows with the square of the cells; those that
/// are asked for are enough for these. With as many on 48 to 64 cells cycles left 0.6 of the residual.
constexpr double cells_of_coarsest_sweeps = 32.0;

/// A visit of the coarsest grid whose relaxations leave more than this share of the residual is taken again with less
/// weight. A new H00 may raise the residual a little: of 300 visits that served their cycles none left more than 1.4 of
/// it, while relaxations that swing around the rim of a contact of a few cells left 4 to 8 times as much, and cycles
/// with them stood still (M >= 200, L <= 2).
constexpr double raised = 2.0;
constexpr double less_weight = 0.8;
constexpr double least_weight = 0.5;

/// The film at the centre may fall by this share of itself in one visit of the coarsest grid: a thick film's pressure
/// answers late, and H00 would go on falling until the bodies meet ((10, 20): a load 20 times as large followed).
constexpr double largest_fall = 0.5;

/// How the coarsest grid is relaxed within one cycle.
struct CoarsestVisits {
  int sweeps;
  double weight = 1.0;  ///< share of all weights
};

int visits_of_coarsest(Cycle kind, std::size_t l) {
  if (kind == Cycle::V || l < 2) return 1;
  return kind == Cycle::W ? 1 << (l - 1) : static_cast<int>(l);
}

double residual_of(Hierarchy& hierarchy, Level& level) {
  update_residual(hierarchy, level);
  return reynolds::residual_norms(level.grid, fields(level), hierarchy.transport, hierarchy.problem.cavitation, level.r)
      .root_mean_square;
}

void visit_coarsest(Hierarchy& hierarchy, CoarsestVisits& visits, const Parameters& how) {
  const core::EnclosingTimer timer(hierarchy.times, core::Part::coarsest);
  Level& level = hierarchy.levels[0];
  const double before = residual_of(hierarchy, level);
  core::copy(level.P, level.correction);  // a place to keep it: the correction is made later
  const double H00 = hierarchy.H00;
  Parameters used = how;
  for (;;) {
    used.relaxation = lighter(how.relaxation, visits.weight);
    relax_with_force_balance(hierarchy, level, visits.sweeps, used);
    const bool swings = !(residual_of(hierarchy, level) <= raised * before);
    if (!swings || visits.weight * less_weight < least_weight) return;
    visits.weight *= less_weight;
    core::copy(level.correction, level.P);
    hierarchy.H00 = H00;
    follow_H00(hierarchy, level);
    update_film(hierarchy, level);
  }
}

void cycle(Hierarchy& hierarchy, std::size_t l, Cycle kind, CoarsestVisits& visits, const Parameters& how) {
  if (l == 0) return visit_coarsest(hierarchy, visits, how);
  Level& level = hierarchy.levels[l];
  for (int sweep = 0; sweep < how.pre; ++sweep) relax(hierarchy, level, how.relaxation);

  restrict_problem(hierarchy, level, hierarchy.levels[l - 1]);
  cycle(hierarchy, l - 1, kind, visits, how);
  if (kind == Cycle::W && l > 1) cycle(hierarchy, l - 1, Cycle::W, visits, how);
  if (kind == Cycle::F && l > 1) cycle(hierarchy, l - 1, Cycle::V, visits, how);
  correct_from_coarse(hierarchy, hierarchy.levels[l - 1], level);

  for (int sweep = 0; sweep < how.post.value_or(1); ++sweep) relax(hierarchy, level, how.relaxation);
}

}  // namespace

void fas_cycle(Hierarchy& hierarchy, std::size_t l, const Parameters& how) {
  const Cycle kind = how.cycle.value_or(Cycle::W);
  const int per_visit = std::max(how.coarsest_sweeps, least_sweeps_per_cycle / visits_of_coarsest(kind, l));
  const double finer = std::max(1.0, hierarchy.levels[0].grid.nx / cells_of_coarsest_sweeps);
  CoarsestVisits visits{static_cast<int>(std::lround(per_visit * finer * finer))};
  cycle(hierarchy, l, kind, visits, how);
}

void relax_with_force_balance(Hierarchy& hierarchy, Level& level, int sweeps, const Parameters& how) {
  // Where the load itself answers to H00, c is the share of that answer that is left to the pressure.
  const double c = how.load_relaxation;
  const double share = c / (1.0 + c * (hierarchy.load_line.slope + hierarchy.outside_line.slope));
  const double Hc = judgement::value_at(level.grid, level.H, 0.0, 0.0);
  const double least_H00 = Hc > 0.0 ? hierarchy.H00 - largest_fall * Hc : -std::numeric_limits<double>::infinity();
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

}  // namespace ehl::fmg
