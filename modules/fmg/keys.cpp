#include "fmg/keys.hpp"

#include <string>

#include "fmg/parameters.hpp"
#include "line_solvers/line_system.hpp"

namespace ehl::fmg {

std::vector<deck::Key> keys() {
  using deck::Key;
  using deck::Type;
  const Parameters defaults;
  return {
      Key{.section = "multigrid",
          .name = "cycle",
          .type = Type::word,
          .default_note = "F to the level of the discretization error, W towards a tolerance",
          .words = {"V", "W", "F"},
          .meaning = "Shape of the coarse grid correction cycle.",
          .source = "Venner and ten Napel 1992: W at high loads"},
      Key{.section = "multigrid",
          .name = "pre",
          .type = Type::integer,
          .default_text = std::to_string(defaults.pre),
          .range = {0, 20},
          .meaning = "Relaxations before the coarse grid correction, nu_1.",
          .source = "Venner and ten Napel 1992"},
      Key{.section = "multigrid",
          .name = "post",
          .type = Type::integer,
          .default_note = "0 to the level of the discretization error, 1 towards a tolerance",
          .range = {0, 20},
          .meaning = "Relaxations after the coarse grid correction, nu_2; 0 becomes 1 where the residual asks for it.",
          .source = "Venner and ten Napel 1992"},
      Key{.section = "multigrid",
          .name = "cycles",
          .type = Type::integer,
          .default_text = std::to_string(defaults.cycles),
          .range = {1, 200},
          .meaning = "Cycles on every level of the full multigrid on its way up, at least; the checks ask for more "
                     "where the level needs them."},
      Key{.section = "multigrid",
          .name = "extra_cycles",
          .type = Type::integer,
          .default_text = std::to_string(defaults.extra_cycles),
          .range = {0, 200},
          .meaning = "Cycles beyond `cycles` on a level below the finest at most, where the checks ask for more."},
      Key{.section = "multigrid",
          .name = "tolerance",
          .default_note = "none: until the cycles no longer change Hc and Hm by a tenth of the discretization error",
          .range = {1e-14, 0.1},
          .meaning =
              "Relative residual of the Reynolds equation to reach on the finest grid (root mean square, over that "
              "of the wedge term).",
          .example = "1e-6"},
      Key{.section = "multigrid",
          .name = "max_cycles",
          .type = Type::integer,
          .default_text = std::to_string(defaults.max_cycles),
          .range = {1, 10000},
          .meaning =
              "Cycles on the finest grid at most, where the checks or the tolerance ask for more than `cycles`."},
      Key{.section = "multigrid",
          .name = "line_solver",
          .type = Type::word,
          .default_text = "elimination",
          .words = {"elimination", "decimation"},
          .meaning =
              "What solves the line systems of the relaxation: elimination of the band, or the paper's decimation "
              "(odd-even reduction). The same solution; the default is the faster.",
          .source = "measured: modules/line_solvers/README.md"},
      Key{.section = "multigrid",
          .name = "kernel_terms",
          .type = Type::integer,
          .default_text = std::to_string(2 * defaults.relaxation.reach + 1),
          .range = {3, 2 * line_solvers::max_reach + 1},
          .meaning = "Terms of the elastic influence along a line that its system keeps: 3, 5 or 7.",
          .source = "Venner and ten Napel 1992: three are enough"},
  };
}

}  // namespace ehl::fmg
