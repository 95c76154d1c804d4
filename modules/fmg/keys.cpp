#include "fmg/keys.hpp"

#include <string>

#include "line_solvers/film_terms.hpp"

namespace ehl::fmg {

std::vector<deck::Key> keys() {
  using deck::Type;
  const Parameters defaults;
  return deck::in_section(
      "multigrid",
      {{.name = "cycle",
        .default_note = "F to the level of the discretization error (V of a line, W of stretched cells), W towards a "
                        "tolerance",
        .words = {"V", "W", "F"},
        .meaning = "Shape of the coarse grid correction cycle.",
        .source = "Venner and ten Napel 1992: W at high loads"},
       {.name = "pre",
        .type = Type::integer,
        .default_note =
            "2; 3 of contacts long along the motion; 3 or 4 of heavy lines whose viscosity rises steeply at the edge",
        .range = {0, 20},
        .meaning = "Relaxations before the coarse grid correction, nu_1.",
        .source = "Venner and ten Napel 1992"},
       {.name = "post",
        .type = Type::integer,
        .default_note = "0 to the level of the discretization error (1 of stretched cells), 1 towards a tolerance; 2 "
                        "or 4 of those with steep viscosity",
        .range = {0, 20},
        .meaning = "Relaxations after the coarse grid correction, nu_2; 0 becomes 1 where the residual asks for it.",
        .source = "Venner and ten Napel 1992"},
       {.name = "cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.cycles),
        .range = {1, 200},
        .meaning = "Cycles on every level of the full multigrid on its way up, at least; the checks ask for more "
                   "where the level needs them."},
       {.name = "extra_cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.extra_cycles),
        .range = {0, 200},
        .meaning = "Cycles beyond `cycles` on a level below the finest at most, where the checks ask for more; with "
                   "[supply] four times as many, and on the first level too."},
       {.name = "tolerance",
        .default_note = "none: until the cycles no longer change Hc and Hm by a tenth of the discretization error",
        .range = {1e-14, 0.1},
        .meaning = "Relative residual of the Reynolds equation to reach on the finest grid (root mean square, over "
                   "that of the wedge term).",
        .example = "1e-6"},
       {.name = "max_cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.max_cycles),
        .range = {1, 10000},
        .meaning = "Cycles on the finest grid at most, where the checks or the tolerance ask for more than `cycles`."},
       {.name = "line_solver",
        .default_text = "elimination",
        .words = {"elimination", "decimation"},
        .meaning = "What solves the line systems of the relaxation: elimination of the band, or the paper's decimation "
                   "(odd-even reduction). The same solution; the default is the faster.",
        .source = "measured: modules/line_solvers/README.md"},
       {.name = "kernel_terms",
        .type = Type::integer,
        .default_text = std::to_string(2 * defaults.relaxation.reach + 1),
        .range = {3, 2 * line_solvers::max_reach + 1},
        .meaning = "Terms of the elastic influence along a line that its system keeps: 3, 5 or 7.",
        .source = "Venner and ten Napel 1992: three are enough"}});
}

Parameters read(deck::Deck& deck) {
  const deck::Part multigrid{deck, "multigrid"};
  Parameters parameters;
  const Cycle cycle = multigrid.choice("cycle", {Cycle::V, Cycle::W, Cycle::F});
  if (multigrid.given("cycle")) parameters.cycle = cycle;
  const int pre = multigrid.integer("pre", 2);
  if (multigrid.given("pre")) parameters.pre = pre;
  const int post = multigrid.integer("post", 1);
  if (multigrid.given("post")) parameters.post = post;
  parameters.cycles = multigrid.integer("cycles", parameters.cycles);
  parameters.extra_cycles = multigrid.integer("extra_cycles", parameters.extra_cycles);
  parameters.max_cycles = multigrid.integer("max_cycles", parameters.max_cycles);
  parameters.tolerance = multigrid.number("tolerance");
  parameters.relaxation.line_solver =
      multigrid.choice("line_solver", {LineSolver::elimination, LineSolver::decimation});
  const int kernel_terms = multigrid.integer("kernel_terms", 2 * parameters.relaxation.reach + 1);
  if (kernel_terms % 2 == 0) multigrid.complain("kernel_terms", "must be 3, 5 or 7: a point and its neighbours");
  parameters.relaxation.reach = kernel_terms / 2;
  if (parameters.pre == 0 && parameters.post.value_or(0) == 0)
    multigrid.complain("pre", "pre + post = 0: a cycle without relaxation cannot converge");
  return parameters;
}

}  // namespace ehl::fmg
