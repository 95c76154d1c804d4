#include "multigrid/keys.hpp"

#include <string>

#include "deck/record.hpp"
#include "line_solvers/film_terms.hpp"

namespace ehl::multigrid {

namespace {

deck::Records<Parameters> records() {
  using namespace deck::record;
  return {
      key("cycle", &Parameters::cycle, {{"V", Cycle::V}, {"W", Cycle::W}, {"F", Cycle::F}},
          otherwise("F if the discretization error decides (V for a line contact), W with a tolerance or on stretched "
                    "cells"),
          "Shape of the multigrid cycle. F becomes W above the first grid if the residual falls too slowly.",
          source("Venner and ten Napel 1992: W at high loads")),
      key("pre", &Parameters::pre, Range{0, 20},
          otherwise("2; 3 for contacts elongated in the rolling direction; 3 or 4 for heavily loaded line contacts "
                    "whose viscosity rises steeply at the edge of the contact"),
          "Number of relaxations before the coarse grid correction, nu_1.", source("Venner and ten Napel 1992")),
      key("post", &Parameters::post, Range{0, 20},
          otherwise("0 if the discretization error decides; 1 with a tolerance, on stretched cells, or where the "
                    "viscosity rises steeply at the edge of the contact; with such viscosity 2 for elongated contacts "
                    "and 2 or 4 for line contacts"),
          "Number of relaxations after the coarse grid correction, nu_2. A value of 0 becomes 1 if the residual falls "
          "too slowly.",
          source("Venner and ten Napel 1992")),
      key("cycles", &Parameters::cycles, Range{1, 200}, own_default,
          "Smallest number of cycles on every level of full multigrid. The convergence checks add cycles where a "
          "level needs them."),
      key("extra_cycles", &Parameters::extra_cycles, Range{0, 200}, own_default,
          "Largest number of cycles in addition to `cycles` on a level below the finest, if the convergence checks "
          "ask for them. [supply] allows four times as many, on the first level too."),
      key("tolerance", &Parameters::tolerance, Range{1e-14, 0.1}, example("1e-6"),
          otherwise("none: the cycles end when they change Hc and Hm by less than a tenth of the discretization error"),
          "Relative residual of the Reynolds equation to reach on the finest grid: its root mean square over that of "
          "the wedge term."),
      key("max_cycles", &Parameters::max_cycles, Range{1, 10000}, own_default,
          "Largest number of cycles on the finest grid, if the convergence checks or the tolerance ask for more than "
          "`cycles`."),
      key("line_solver", by_default("elimination"), words({"elimination", "decimation"}),
          "Solver of the line systems of the relaxation. elimination: Gaussian elimination of the band, the faster "
          "one. decimation: odd-even reduction, as in the paper. Both give the same solution.",
          source("modules/line_solvers/README.md")),
      key("kernel_terms", integer, odd(3, 2 * line_solvers::max_reach + 1),
          by_default(std::to_string(2 * RelaxationParameters{}.reach + 1)),
          "Number of terms of the elastic influence along a line that the line system keeps: 3, 5 or 7.",
          remedy("a point and its neighbours"), source("Venner and ten Napel 1992: three are enough"))};
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("multigrid", records()); }

Parameters read(deck::Deck& deck) {
  const deck::Part multigrid{deck, "multigrid"};
  Parameters parameters = deck::read(multigrid, records());
  parameters.relaxation.line_solver =
      multigrid.choice("line_solver", {LineSolver::elimination, LineSolver::decimation});
  parameters.relaxation.reach = multigrid.integer("kernel_terms", 2 * parameters.relaxation.reach + 1) / 2;
  if (parameters.pre == 0 && parameters.post.value_or(0) == 0)
    multigrid.complain("pre", "pre + post = 0: a cycle without relaxation cannot converge");
  return parameters;
}

}  // namespace ehl::multigrid
