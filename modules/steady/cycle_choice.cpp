#include "steady/cycle_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/film_formulas.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {
namespace {

/// True if full weights oscillate where epsilon is steep.
bool steep_edge(const Scene& scene) { return log_viscosity_at_edge(scene) > scene.tuning.steep_log_viscosity; }

/// Relaxations before and after the coarse grid correction; more than usual if coarse grids return poor corrections.
struct Relaxations {
  int pre = 0, post = 0;
};
Relaxations more_relaxations(const Scene& scene, const Start& start) {
  if (!elongated(scene.tuning, scene.contact.shape) || !core::stretched(scene.grid)) return {start.pre, start.post};
  const bool steep = log_viscosity_at_edge(scene) > scene.tuning.steep_log_viscosity_of_slender;
  return steep ? Relaxations{3, 2} : Relaxations{3, 1};
}

/// F(2,0) cycles leave the smallest algebraic error of Hc and Hm for their work, W(2,1) cycles the smallest residual.
/// On a line contact V cycles are cheaper than F cycles at the same error, because its next coarser grid costs half as
/// much as the fine one. Stretched cells take W cycles: most of their coarser grids are visited once, so that W costs
/// hardly more than F. Heavily loaded line contacts with more relaxations keep V cycles for a given tolerance too.
/// [bench: cycle_choice]
void choose_cycle(const Scene& scene, const Start& start, multigrid::Parameters& parameters) {
  const Relaxations more = more_relaxations(scene, start);
  if (more.pre > 0) {
    if (!parameters.pre) parameters.pre = more.pre;
    if (!parameters.post) parameters.post = more.post;
    parameters.settling_sweeps = scene.tuning.settling_sweeps;
    parameters.settling_weight = scene.tuning.settling_weight;
  }
  const bool heavy_line = scene.grid.line && more.pre > 0;
  const bool least_residual = core::stretched(scene.grid) || (std::isfinite(scene.solver.tolerance) && !heavy_line);
  const multigrid::Cycle shortest = scene.grid.line ? multigrid::Cycle::V : multigrid::Cycle::F;
  if (!parameters.cycle) parameters.cycle = least_residual ? multigrid::Cycle::W : shortest;
  if (!parameters.post) parameters.post = least_residual || steep_edge(scene) ? 1 : 0;
}

/// Cells along x of the coarsest grid: few enough for its relaxations to solve it. A slender contact in a narrow domain
/// gets twice as many. For an oblique contact the mesh size is limited to a multiple of the shorter half of the
/// contact; for heavily loaded line contacts on long domains, too, since a coarser grid underestimates dF/dH00, and
/// every cycle inherits that error. [bench: widest_coarsest_step]
int coarsest_cells(const Scene& scene, const Start& start) {
  const double length = scene.grid.X_b - scene.grid.X_a;
  const auto with_step_of = [&](double widest) {
    int cells = start.coarsest;
    while (length / cells > widest) cells *= 2;
    return cells;
  };
  if (scene.grid.line)
    return start.pre > 0 ? with_step_of(scene.tuning.widest_coarsest_step_of_heavy_line) : start.coarsest;
  if (contact::gap(scene.contact.shape).oblique()) {
    const Tuning& tuning = scene.tuning;
    const double widest =
        elongated(tuning, scene.contact.shape) ? tuning.widest_coarsest_step_elongated : tuning.widest_coarsest_step;
    return with_step_of(widest * (scene.contact.size / scene.contact.slenderness));
  }
  const double width = scene.grid.Y_b - scene.grid.Y_a;
  return contact::circular(scene.contact.shape) || length < scene.tuning.narrow_domain * width ? start.coarsest
                                                                                               : 2 * start.coarsest;
}

/// -dH/d ln(load) of the expected central film: twice the film if the contact is nearly rigid, little if it is elastic.
double film_slope(const Scene& scene) {
  constexpr double step = 0.01;
  const auto film = [&](double M) {
    return contact::nijenbanning_venner_moes(M, scene.contact.L, scene.contact.shape);
  };
  const double power =
      std::log(film(scene.contact.M * (1.0 - step)) / film(scene.contact.M * (1.0 + step))) / (2.0 * step);
  return power * scene.contact.film;
}

/// Step limit: the largest pressure change of one relaxation, given as a change of ln eta with its slope at P = 0.
/// Larger steps make the front of a spike alternate from line to line, because the X sweep holds epsilon fixed; the Y
/// sweep then amplifies that. A line contact, whose points are solved together, needs no limit.
/// [bench: most_change_of_log_viscosity]
double most_change(const Scene& scene) {
  if (scene.grid.line) return std::numeric_limits<double>::infinity();
  double P = 0.0, slope;
  rheology::log_viscosity_slope(scene.viscosity, {&P, 1}, {&slope, 1});
  return scene.tuning.most_change_of_log_viscosity / slope;
}

}  // namespace

// The Hertz pressure at the distance s inside the edge is p_h sqrt(2 s/l), where l is the semi-axis across the edge.
double log_viscosity_at_edge(const Scene& scene) {
  const double P = std::sqrt(2.0 * scene.contact.film_zone / contact::extent(scene.contact.shape).shorter);
  return rheology::log_viscosity_at(scene.viscosity, std::min(1.0, P));
}

double steep_damping(const Scene& scene) { return steep_edge(scene) ? scene.tuning.damping_where_steep : 1.0; }

multigrid::Parameters parameters_of(const Scene& scene, const Start& start) {
  const Tuning& tuning = scene.tuning;
  const bool is_elongated = elongated(tuning, scene.contact.shape);
  multigrid::Parameters parameters = scene.solver;
  parameters.coarsest_sweeps = std::max(parameters.coarsest_sweeps, start.balances);
  // Elongated oblique contacts get Y sweeps from the first cycle on. [bench: across_of_oblique_contacts]
  parameters.relaxation.across = (start.across || is_elongated) && !core::stretched(scene.grid);
  // If a Y sweep follows, the X sweep on square cells is not damped where epsilon is steep: damped, it amplifies the
  // odd-even mode at the inlet edge. Coarse grids, which have epsilon at the nodes, keep the damping.
  // [bench: steep_before_across]
  parameters.relaxation.steep_before_across = 1.0 / steep_damping(scene);
  // On coarse grids of oblique contacts, with epsilon at the nodes, both sweeps correct the same residual where a spike
  // crosses the lines.
  if (contact::gap(scene.contact.shape).oblique())
    parameters.relaxation.coarse_before_across = tuning.coarse_before_across;
  parameters.least_coarsest_cells = std::max(parameters.least_coarsest_cells, coarsest_cells(scene, start));
  // The change of H00 = film - approach with the load, relative to that of a dry circle. Part of the film's share
  // counts: without elastic bodies the pressure responds more slowly. With zero pressure on the boundary so thick a
  // film does not occur.
  const double film = scene.far_field ? tuning.share_of_film_slope * film_slope(scene) : 0.0;
  parameters.load_relaxation *= (scene.contact.shape.approach + film) / contact::relative_load(scene.contact.shape);
  // Width of the zone of Gauss-Seidel changes, in the film zones at inlet and outlet. [bench: film_zones_of_line]
  parameters.relaxation.line_zero = tuning.film_zones_of_line * scene.contact.film_zone;
  // The crossover compares the coupling by epsilon with the coupling by the film.
  parameters.relaxation.crossover *= scene.contact.shape.p_h / scene.contact.shape.a;
  const bool flattened = scene.contact.film < scene.contact.shape.approach;
  // The points of a single line are solved together, so that changes may be distributed even where epsilon couples the
  // points strongly. This does not hold for nearly rigid bodies.
  if (scene.grid.line && flattened) parameters.relaxation.crossover = tuning.crossover_of_line;
  if (scene.grid.line) {
    // A fixed crossover alone would admit ever thinner films on finer grids. There Gauss-Seidel changes, whose film
    // response is taken as local, amplify errors that are smooth over sqrt(epsilon), and the coarse grids cannot remove
    // these.
    parameters.relaxation.least_single_epsilon = tuning.least_single_epsilon_of_line;
    parameters.relaxation.weight_distributed = tuning.weight_of_line;
  }
  if (core::stretched(scene.grid)) {  // changes are distributed to two neighbours instead of four
    parameters.relaxation = multigrid::lighter(parameters.relaxation, tuning.weight_when_stretched);
    parameters.relaxation.weight_single_steep *= tuning.steep_when_stretched;
  }
  parameters.relaxation.most_change = most_change(scene);
  parameters.extend_boundary = is_elongated;
  choose_cycle(scene, start, parameters);
  return parameters;
}

}  // namespace ehl::steady
