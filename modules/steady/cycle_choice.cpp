#include "steady/cycle_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/film_formulas.hpp"
#include "steady/resolution.hpp"

namespace ehl::steady {
namespace {

/// log_viscosity_at_edge() from which on full weights oscillate where epsilon is steep, and are lowered sooner or
/// later. Of 36 loads, M = 5 to 5000, L = 23 to 30, those above take up to 60 % fewer cycles with the weight below,
/// those below it take more.
constexpr double steep_log_viscosity = 20.0;
constexpr double caution_where_steep = 0.8;

bool steep_edge(const Scene& scene) { return log_viscosity_at_edge(scene) > steep_log_viscosity; }

/// Likewise of contacts long along the motion, on stretched cells, from which on they take (3,2) relaxations, and below
/// it (3,1). R_x/R_y = 100, (1000, 10) and (1000, 15): 0.39 and 0.33 left per W cycle, with W(2,1) 0.50 and 0.59; 200,
/// (20, 15), (1000, 10) and (1000, 15): 0.35, 0.39 and 0.43, with W(2,1) 0.51, 0.53 and no solution. Below, 200,
/// (100, 5): 0.36, with W(2,1) by a later start; (100, 10): 0.42, with W(3,2) 0.54, W(2,1) 0.32.
constexpr double steep_log_viscosity_of_slender = 9.0;

/// In a cycle; of more than usual, where coarse grids send up what is far off.
struct Relaxations {
  int pre = 0, post = 0;
};
Relaxations more_relaxations(const Scene& scene, const Start& start) {
  if (!long_along_motion(scene.shape) || !core::stretched(scene.grid)) return {start.pre, start.post};
  return log_viscosity_at_edge(scene) > steep_log_viscosity_of_slender ? Relaxations{3, 2} : Relaxations{3, 1};
}
/// Behind an interpolation, likewise: 42 heavy lines with a steep edge (starts.cpp) begin at a later start 9 times with
/// 2 relaxations at full weight, 4 times with 4 at 0.4 or 0.5, 22 and 29 times with 8 and 16 at full weight, which lead
/// away.
constexpr int settling_sweeps = 4;
constexpr double settling_weight = 0.4;

/// F(2,0) cycles leave the least algebraic error of Hc and Hm for their work, W(2,1) the least residual. Along a line,
/// where a coarse grid is half the work of a finer one, V cycles leave as little as F for two thirds of it. Stretched
/// cells take W anyhow: most of their coarser grids are visited once, so that W is 1 % more work than F. With
/// F(2,0) (1000, 15) at R_x/R_y = 100 does not begin at its first start; with W(2,0) and W(2,1) (100, 10) at 200 takes
/// 140 and 57 work units, (20, 15) at 200 85 and 41, at 50 49 and 59. Heavy lines with more relaxations take V cycles
/// towards a tolerance too: (2000, 25) to 1e-9 0.03 s, where W(2,1) cycles left it to Newton's method and 0.9 s.
void choose_cycle(const Scene& scene, const Start& start, fmg::Parameters& parameters) {
  const Relaxations more = more_relaxations(scene, start);
  if (more.pre > 0) {
    if (!parameters.pre) parameters.pre = more.pre;
    if (!parameters.post) parameters.post = more.post;
    parameters.settling_sweeps = settling_sweeps;
    parameters.settling_weight = settling_weight;
  }
  const bool heavy_line = scene.grid.line && more.pre > 0;
  const bool least_residual = core::stretched(scene.grid) || (std::isfinite(scene.multigrid.tolerance) && !heavy_line);
  const fmg::Cycle shortest = scene.grid.line ? fmg::Cycle::V : fmg::Cycle::F;
  if (!parameters.cycle) parameters.cycle = least_residual ? fmg::Cycle::W : shortest;
  if (!parameters.post) parameters.post = least_residual || steep_edge(scene) ? 1 : 0;
}

/// On a long domain the coarsest grid of a heavy line misses a third of the load that a change of H00 brings, and every
/// cycle leaves as much: X = -4.5 to 1.5, (200, 20) and (200, 25) take 154 and 119 work units with a step of 0.19, 45
/// and 51 with 0.09; with 0.12 to 0.14 cycles leave no more than with less.
constexpr double widest_coarsest_step_of_heavy_line = 0.15;

/// Cells along x of the coarsest grid: few enough for its relaxations to solve it, and in a narrow domain, where the
/// contact is slender, twice as many for a grid that holds it better. Aslant a step is at most so many times the
/// shorter half of the contact: of R_x/R_y = 0.005 to 0.05, M = 1000, cycles leave 0.1 with 2.1, 0.24 with 2.9; of
/// (100, 5) at 100, where the film is thinner, 0.46 with 2.5, 0.2 with 1.3. At 200 (1000, 15) begins with 0.6, not with
/// 1.2; with 0.3 the coarsest grid is three quarters of the time, of (100, 5) 110 s instead of 25.
int coarsest_cells(const Scene& scene, const Start& start) {
  const double length = scene.grid.X_b - scene.grid.X_a;
  const auto with_step_of = [&](double widest) {
    int cells = start.coarsest;
    while (length / cells > widest) cells *= 2;
    return cells;
  };
  if (scene.grid.line) return start.pre > 0 ? with_step_of(widest_coarsest_step_of_heavy_line) : start.coarsest;
  if (contact::gap(scene.shape).aslant()) {
    const double widest_coarsest_step = long_along_motion(scene.shape) ? 0.8 : 2.5;
    const double shorter = contact_size(scene.M, scene.L, scene.shape) / slenderness(scene.M, scene.L, scene.shape);
    return with_step_of(widest_coarsest_step * shorter);
  }
  const double width = scene.grid.Y_b - scene.grid.Y_a;
  constexpr double narrow = 1.99;
  return contact::circular(scene.shape) || length < narrow * width ? start.coarsest : 2 * start.coarsest;
}

/// -dH/d ln(load) of the central film to expect: twice the film where the contact is nearly rigid, little where it is
/// elastic.
double film_slope(const Scene& scene) {
  constexpr double step = 0.01;
  const auto film = [&](double M) { return contact::nijenbanning_venner_moes(M, scene.L, scene.shape); };
  const double power = std::log(film(scene.M * (1.0 - step)) / film(scene.M * (1.0 + step))) / (2.0 * step);
  return power * expected_central_film(scene.M, scene.L, scene.shape);
}

/// Along one line, whose points are solved together, a change may be distributed however strongly they are coupled: of
/// 1 to 1e8 the cycles leave 0.2 to 0.5 of the residual with 1 to 10, 0.02 to 0.15 with 1e3 and 1e4 (eleven loads
/// from (5, 0) to (200, 10), 256 and 1024 cells, of which 3 to 5 do not converge with 1e6 and more). Of bodies that
/// stay nearly rigid, M = 1, cycles with it leave 0.7.
constexpr double crossover_of_line = 3e3;
/// On ever finer grids that would be ever thinner films: single changes, to which the film answers near them alone,
/// raise what is smooth over sqrt(epsilon), and the coarser grids do not keep up. Without it 3 and 12 of 77 lines on
/// 4096 and 8192 cells went to Newton's method; of 0.01, 0.02, 0.03 and 0.05 1 and 2 with the first, none with the
/// others, and none of M <= 200 needs a second start with 0.02, one with the last two.
constexpr double least_single_epsilon_of_line = 0.02;

/// With 1, 0.9, 0.8 and 0.7 cycles of the 56 lines up to M = 200 on 1024 cells take 2210, 1939, 1880 and 2130 work
/// units, and of all 77 two, one, none and one are left to Newton's method.
constexpr double weight_of_line = 0.8;

/// Changes on stretched cells are distributed to two neighbours instead of four. R_x/R_y = 20, (20, 10), 512 x 512
/// cells: of 1, 0.85, 0.7 and 0.5 the cycles leave 0.43, 0.17, 0.16 and 0.26.
constexpr double weight_when_stretched = 0.8;
/// Where epsilon is steep, too: of 1, 0.8 and 0.6 the cycles leave 0.36, 0.37, 0.42 of (20, 15) at R_x/R_y = 50, 0.58,
/// 0.48, 0.50 of it at 200, held there; of 0.8 and 0.6 0.58 and 0.34 of (100, 10) at 200, and (1000, 15) at 100 begins
/// at the first start with 0.6 alone.
constexpr double steep_when_stretched = 0.6;

/// Of a pressure in one relaxation, as a change of ln eta at its slope at P = 0. Lines along X, which hold epsilon,
/// made a spike's front alternate from line to line by 20 of it, and those across drove that on. Of 3, 6, 12 and no
/// bound 0.35, 0.31, 0.44, 0.46 are left of (20, 15) at R_x/R_y = 50. Along one line, whose points are solved together,
/// it serves nobody: 77 loads on 1024 cells take 3699 work units with it, 3689 without.
double most_change(const Scene& scene) {
  constexpr double most_change_of_log_viscosity = 6.0;
  if (scene.grid.line) return std::numeric_limits<double>::infinity();
  double P = 0.0, slope;
  rheology::log_viscosity_slope(scene.viscosity, {&P, 1}, {&slope, 1});
  return most_change_of_log_viscosity / slope;
}

/// With epsilon at the nodes a coarse grid lets through what neither lines along X nor those across foresee, and both
/// together change too much where a spike crosses them. Of 1, 0.6, 0.5 and 0.4 cycles leave 0.65, 0.34, 0.35, 0.36 of
/// (105, 13.9) at R_x/R_y = 21.3 and 5 degrees, 0.73, 0.36, 0.69, 0.41 of (1000, 5) at 200 and 45; with 0.5 of the
/// single changes alone 0.75 of (20, 15) there, of which 0.33 is left with 0.6.
constexpr double coarse_before_across_aslant = 0.6;

}  // namespace

// The Hertz pressure at the distance s inside the edge is p_h sqrt(2 s/l), l the semi-axis across it.
double log_viscosity_at_edge(const Scene& scene) {
  const double zone = film_zone(scene.M, scene.L, scene.shape);
  const double P = std::sqrt(2.0 * zone / contact::extent(scene.shape).shorter);
  return rheology::log_viscosity_at(scene.viscosity, std::min(1.0, P));
}

double steep_caution(const Scene& scene) { return steep_edge(scene) ? caution_where_steep : 1.0; }

fmg::Parameters parameters_of(const Scene& scene, const Start& start) {
  fmg::Parameters parameters = scene.multigrid;
  parameters.coarsest_sweeps = std::max(parameters.coarsest_sweeps, start.balances);
  // Aslant, long contacts need it sooner or later: three cycles instead of five of M = 1000.
  parameters.relaxation.across = (start.across || long_along_motion(scene.shape)) && !core::stretched(scene.grid);
  // Where lines along Y follow, those along X need no caution: behind as small changes as it leaves them, they raise
  // what alternates from line to line at the inlet's edge. With caution and without cycles at 45 degrees leave 0.60 and
  // 0.29 of (100, 15) at R_x/R_y = 100, 0.60 and 0.32 of (20, 15) at 200, 0.21 and 0.25 of (1000, 15); without on
  // coarse grids too, whose epsilon is of the nodes, 0.41 of this. Of weights raised where none was needed (1000, 5) at
  // 200 takes a second start.
  parameters.relaxation.steep_before_across = 1.0 / steep_caution(scene);
  if (contact::gap(scene.shape).aslant()) parameters.relaxation.coarse_before_across = coarse_before_across_aslant;
  parameters.least_coarsest_cells = std::max(parameters.least_coarsest_cells, coarsest_cells(scene, start));
  // The change of H00 = film - approach that a load brings, over that of a dry circle. Of the film half: without bodies
  // to lean on the pressure answers later. With no pressure on the boundary a film that thick is not reached.
  const double film = scene.far_field ? 0.75 * film_slope(scene) : 0.0;
  parameters.load_relaxation *= (scene.shape.approach + film) / contact::relative_load(scene.shape);
  // Single changes stand in the zones in which the film is made. Of 1, 2, 4 and 8 of their widths, eleven loads from
  // (5, 0) to (200, 10): with 8 all converge, nine from the first start; with 1 three do not.
  constexpr double film_zones = 8.0;
  parameters.relaxation.line_zero = film_zones * film_zone(scene.M, scene.L, scene.shape);
  // The coupling by the film, against which that by epsilon is held.
  parameters.relaxation.crossover *= scene.shape.p_h / scene.shape.a;
  const bool flattened = expected_central_film(scene.M, scene.L, scene.shape) < scene.shape.approach;
  if (scene.grid.line && flattened) parameters.relaxation.crossover = crossover_of_line;
  if (scene.grid.line) {
    parameters.relaxation.least_single_epsilon = least_single_epsilon_of_line;
    parameters.relaxation.weight_distributed = weight_of_line;
  }
  if (core::stretched(scene.grid)) {
    parameters.relaxation = fmg::lighter(parameters.relaxation, weight_when_stretched);
    parameters.relaxation.weight_single_steep *= steep_when_stretched;
  }
  parameters.relaxation.most_change = most_change(scene);
  parameters.lead_inward = long_along_motion(scene.shape);
  choose_cycle(scene, start, parameters);
  return parameters;
}

}  // namespace ehl::steady
