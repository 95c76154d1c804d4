#include "steady/cycle_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/film_formulas.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/resolution.hpp"
#include "steady/starts.hpp"

namespace ehl::steady {
namespace {

/// A scene for which the parameters are chosen.
struct Choice {
  const Scene& scene;
  const Tuning& tuning;
  const Start& start;
  Features is;
  bool wants_least_residual = false;  ///< the residual is to fall to a tolerance
};

Choice choice_of(const Scene& scene, const Start& start) {
  return {scene, scene.tuning, start, features_of(scene), std::isfinite(scene.solver.tolerance)};
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

using Parameters = multigrid::Parameters;

// The numbers that every contact scales.
void scale(const Choice& choice, Parameters& parameters) {
  const Scene& scene = choice.scene;
  const contact::Ellipse& shape = scene.contact.shape;
  parameters.coarsest_sweeps = std::max(parameters.coarsest_sweeps, choice.start.balances);
  // The change of H00 = film - approach with the load, relative to that of a dry circle. Part of the film's share
  // counts: without elastic bodies the pressure responds more slowly. With zero pressure on the boundary so thick a
  // film does not occur.
  const double film = scene.far_field ? choice.tuning.share_of_film_slope * film_slope(scene) : 0.0;
  parameters.load_relaxation *= (shape.approach + film) / contact::relative_load(shape);
  // Width of the zone of Gauss-Seidel changes, in the film zones at inlet and outlet. [bench: film_zones_of_line]
  parameters.relaxation.line_zero = choice.tuning.film_zones_of_line * scene.contact.film_zone;
  // The crossover compares the coupling by epsilon with the coupling by the film.
  parameters.relaxation.crossover *= shape.p_h / shape.a;
}

// Step limit, given as a change of ln eta with its slope at P = 0.
void limit_steps(const Choice& choice, Parameters& parameters) {
  double P = 0.0, slope;
  rheology::log_viscosity_slope(choice.scene.viscosity, {&P, 1}, {&slope, 1});
  parameters.relaxation.most_change = choice.tuning.most_change_of_log_viscosity / slope;
}

// Mesh size of the coarsest grid: at most `widest`.
void limit_coarsest_step(double widest, const Choice& choice, Parameters& parameters) {
  const double length = choice.scene.grid.X_b - choice.scene.grid.X_a;
  int cells = choice.start.coarsest;
  while (length / cells > widest) cells *= 2;
  parameters.least_coarsest_cells = std::max(parameters.least_coarsest_cells, cells);
}

void relax_more(int pre, int post, const Choice& choice, Parameters& parameters) {
  if (!parameters.pre) parameters.pre = pre;
  if (!parameters.post) parameters.post = post;
  parameters.settling_sweeps = choice.tuning.settling_sweeps;
  parameters.settling_weight = choice.tuning.settling_weight;
}

bool heavy_line(const Choice& choice) { return choice.is.line && choice.start.pre > 0; }

// The table: every rule whose condition holds sets its parameters, in this order. The names are rows of
// tests/bench/tuning.csv. Parameters that the deck gives (cycle, pre, post) are kept.
struct Rule {
  const char* name;
  bool (*when)(const Choice& choice);
  void (*set)(const Choice& choice, Parameters& parameters);
};

constexpr Rule rules[] = {
    // ---- Y sweep
    {"across_of_oblique_contacts",  // on square cells from the first cycle on
     [](const Choice& c) { return (c.start.across || c.is.elongated) && !c.is.stretched; },
     [](const Choice&, Parameters& p) { p.relaxation.across = true; }},
    // If a Y sweep follows, the X sweep on square cells is not damped where epsilon is steep: damped, it amplifies the
    // odd-even mode at the inlet edge. Coarse grids, which have epsilon at the nodes, keep the damping.
    {"steep_before_across", [](const Choice& c) { return c.is.steep; },
     [](const Choice& c, Parameters& p) { p.relaxation.steep_before_across = 1.0 / c.tuning.damping_where_steep; }},
    // On coarse grids, with epsilon at the nodes, both sweeps correct the same residual where a spike crosses the
    // lines.
    {"coarse_before_across", [](const Choice& c) { return c.is.oblique; },
     [](const Choice& c, Parameters& p) { p.relaxation.coarse_before_across = c.tuning.coarse_before_across; }},

    // ---- Kind and weights of the changes
    // The points of a single line are solved together, so that changes may be distributed even where epsilon couples
    // the points strongly. This does not hold for nearly rigid bodies.
    {"crossover_of_line", [](const Choice& c) { return c.is.line && c.is.flattened; },
     [](const Choice& c, Parameters& p) { p.relaxation.crossover = c.tuning.crossover_of_line; }},
    // A fixed crossover alone would admit ever thinner films on finer grids. There Gauss-Seidel changes, whose film
    // response is taken as local, amplify errors that are smooth over sqrt(epsilon), and the coarse grids cannot remove
    // these.
    {"least_single_epsilon_of_line", [](const Choice& c) { return c.is.line; },
     [](const Choice& c, Parameters& p) { p.relaxation.least_single_epsilon = c.tuning.least_single_epsilon_of_line; }},
    {"weight_of_line", [](const Choice& c) { return c.is.line; },
     [](const Choice& c, Parameters& p) { p.relaxation.weight_distributed = c.tuning.weight_of_line; }},
    // Changes are distributed to two neighbours instead of four.
    {"weight_when_stretched", [](const Choice& c) { return c.is.stretched; },
     [](const Choice& c, Parameters& p) {
       p.relaxation = multigrid::lighter(p.relaxation, c.tuning.weight_when_stretched);
       p.relaxation.weight_single_steep *= c.tuning.steep_when_stretched;
     }},
    // Larger steps make the front of a spike alternate from line to line, because the X sweep holds epsilon fixed; the
    // Y sweep then amplifies that. A line contact, whose points are solved together, needs no limit.
    {"most_change_of_log_viscosity", [](const Choice& c) { return !c.is.line; }, limit_steps},
    {"extend_boundary", [](const Choice& c) { return c.is.elongated || c.is.line; },
     [](const Choice&, Parameters& p) { p.extend_boundary = true; }},

    // ---- Coarsest grid: few enough cells for its relaxations to solve it
    {"cells_of_coarsest_sweeps", [](const Choice&) { return true; },
     [](const Choice& c, Parameters& p) {
       p.least_coarsest_cells = std::max(p.least_coarsest_cells, c.start.coarsest);
     }},
    // On long domains a coarser grid underestimates dF/dH00, and every cycle inherits that error.
    {"widest_coarsest_step_of_heavy_line", heavy_line,
     [](const Choice& c, Parameters& p) { limit_coarsest_step(c.tuning.widest_coarsest_step_of_heavy_line, c, p); }},
    // A multiple of the shorter half of the contact.
    {"widest_coarsest_step", [](const Choice& c) { return !c.is.line && c.is.oblique; },
     [](const Choice& c, Parameters& p) {
       const double widest = c.is.elongated ? c.tuning.widest_coarsest_step_elongated : c.tuning.widest_coarsest_step;
       limit_coarsest_step(widest * (c.scene.contact.size / c.scene.contact.slenderness), c, p);
     }},

    // ---- Relaxations: more than usual where coarse grids return poor corrections
    {"starts_of_heavy_lines", heavy_line,
     [](const Choice& c, Parameters& p) { relax_more(c.start.pre, c.start.post, c, p); }},
    {"steep_log_viscosity_of_slender", [](const Choice& c) { return c.is.elongated && c.is.stretched; },
     [](const Choice& c, Parameters& p) {
       relax_more(3, c.is.edge > c.tuning.steep_log_viscosity_of_slender ? 2 : 1, c, p);
     }},

    // ---- Cycle. F(2,0) leaves the smallest algebraic error of Hc and Hm for its work, W(2,1) the smallest residual.
    // On
    // a line contact V cycles are cheaper than F cycles at the same error, because its next coarser grid costs half as
    // much as the fine one. Stretched cells take W cycles: most of their coarser grids are visited once, so that W
    // costs
    // hardly more than F. Heavily loaded line contacts with more relaxations keep V cycles towards a tolerance too.
    {"cycle_choice", [](const Choice& c) { return c.is.stretched || (c.wants_least_residual && !heavy_line(c)); },
     [](const Choice&, Parameters& p) {
       if (!p.cycle) p.cycle = multigrid::Cycle::W;
       if (!p.post) p.post = 1;
     }},
    {"steep_log_viscosity", [](const Choice& c) { return c.is.steep; },
     [](const Choice&, Parameters& p) {
       if (!p.post) p.post = 1;
     }},
    {"cycle_choice", [](const Choice& c) { return c.is.line; },
     [](const Choice&, Parameters& p) {
       if (!p.cycle) p.cycle = multigrid::Cycle::V;
     }},
    {"cycle_choice", [](const Choice&) { return true; },
     [](const Choice&, Parameters& p) {
       if (!p.cycle) p.cycle = multigrid::Cycle::F;
       if (!p.post) p.post = 0;
     }},
};

}  // namespace

Features features_of(const Scene& scene) {
  const contact::Ellipse& shape = scene.contact.shape;
  Features is{.line = scene.grid.line,
              .stretched = core::stretched(scene.grid),
              .oblique = contact::gap(shape).oblique(),
              .elongated = elongated(scene.tuning, shape),
              .circular = contact::circular(shape),
              .flattened = scene.contact.film < shape.approach,
              .resolved = held_by(usual_start().cells, scene),
              .edge = log_viscosity_at_edge(scene)};
  is.steep = is.edge > scene.tuning.steep_log_viscosity;
  is.steep_for_line = !(is.edge < scene.tuning.steep_log_viscosity_of_line);
  return is;
}

// The Hertz pressure at the distance s inside the edge is p_h sqrt(2 s/l), where l is the semi-axis across the edge.
double log_viscosity_at_edge(const Scene& scene) {
  const double P = std::sqrt(2.0 * scene.contact.film_zone / contact::extent(scene.contact.shape).shorter);
  return rheology::log_viscosity_at(scene.viscosity, std::min(1.0, P));
}

double steep_damping(const Scene& scene) { return features_of(scene).steep ? scene.tuning.damping_where_steep : 1.0; }

multigrid::Parameters parameters_of(const Scene& scene, const Start& start) {
  const Choice choice = choice_of(scene, start);
  multigrid::Parameters parameters = scene.solver;
  scale(choice, parameters);
  for (const Rule& rule : rules)
    if (rule.when(choice)) rule.set(choice, parameters);
  return parameters;
}

std::vector<std::string> rules_of(const Scene& scene, const Start& start) {
  const Choice choice = choice_of(scene, start);
  std::vector<std::string> names;
  for (const Rule& rule : rules)
    if (rule.when(choice) && (names.empty() || names.back() != rule.name)) names.emplace_back(rule.name);
  return names;
}

}  // namespace ehl::steady
