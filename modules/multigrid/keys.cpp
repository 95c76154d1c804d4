#include "multigrid/keys.hpp"

#include <string>

#include "line_solvers/film_terms.hpp"

namespace ehl::multigrid {

std::vector<deck::Key> keys() {
  using deck::Type;
  const Parameters defaults;
  return deck::in_section(
      "multigrid",
      {{.name = "cycle",
        .default_note =
            "F if the discretization error decides (V for a line contact), W with a tolerance or on stretched cells",
        .words = {"V", "W", "F"},
        .meaning = "Shape of the multigrid cycle. F becomes W above the first grid if the residual falls too slowly.",
        .source = "Venner and ten Napel 1992: W at high loads"},
       {.name = "pre",
        .type = Type::integer,
        .default_note = "2; 3 for contacts elongated in the rolling direction; 3 or 4 for heavily loaded line contacts "
                        "whose viscosity rises steeply at the edge of the contact",
        .range = {0, 20},
        .meaning = "Number of relaxations before the coarse grid correction, nu_1.",
        .source = "Venner and ten Napel 1992"},
       {.name = "post",
        .type = Type::integer,
        .default_note = "0 if the discretization error decides; 1 with a tolerance, on stretched cells, or where the "
                        "viscosity rises steeply at the edge of the contact; with such viscosity 2 for elongated "
                        "contacts and 2 or 4 for line contacts",
        .range = {0, 20},
        .meaning = "Number of relaxations after the coarse grid correction, nu_2. A value of 0 becomes 1 if the "
                   "residual falls too slowly.",
        .source = "Venner and ten Napel 1992"},
       {.name = "cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.cycles),
        .range = {1, 200},
        .meaning = "Smallest number of cycles on every level of full multigrid. The convergence checks add cycles "
                   "where a level needs them."},
       {.name = "extra_cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.extra_cycles),
        .range = {0, 200},
        .meaning = "Largest number of cycles in addition to `cycles` on a level below the finest, if the convergence "
                   "checks ask for them. [supply] allows four times as many, on the first level too."},
       {.name = "tolerance",
        .default_note =
            "none: the cycles end when they change Hc and Hm by less than a tenth of the discretization error",
        .range = {1e-14, 0.1},
        .meaning = "Relative residual of the Reynolds equation to reach on the finest grid: its root mean square over "
                   "that of the wedge term.",
        .example = "1e-6"},
       {.name = "max_cycles",
        .type = Type::integer,
        .default_text = std::to_string(defaults.max_cycles),
        .range = {1, 10000},
        .meaning = "Largest number of cycles on the finest grid, if the convergence checks or the tolerance ask for "
                   "more than `cycles`."},
       {.name = "line_solver",
        .default_text = "elimination",
        .words = {"elimination", "decimation"},
        .meaning = "Solver of the line systems of the relaxation. elimination: Gaussian elimination of the band, the "
                   "faster one. decimation: odd-even reduction, as in the paper. Both give the same solution.",
        .source = "modules/line_solvers/README.md"},
       {.name = "kernel_terms",
        .type = Type::integer,
        .default_text = std::to_string(2 * defaults.relaxation.reach + 1),
        .range = {3, 2 * line_solvers::max_reach + 1},
        .meaning = "Number of terms of the elastic influence along a line that the line system keeps: 3, 5 or 7.",
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

}  // namespace ehl::multigrid
