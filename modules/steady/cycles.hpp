#pragma once
// Cycles on one level until a judge is content, with more caution where they do not reduce the residual.
#include <cstddef>
#include <functional>
#include <string>

#include "fmg/hierarchy.hpp"
#include "steady/solution.hpp"
#include "steady/state_of_level.hpp"

namespace ehl::steady {

/// Factors on the under-relaxation weights of the relaxation, 1 where all goes well.
struct Caution {
  double all = 1.0;    ///< on every weight
  double steep = 1.0;  ///< once more on that of single changes where epsilon differs by orders from cell to cell
};

struct CyclesResult {
  CyclesEnd end = CyclesEnd::content;
  std::string unmet;  ///< what the judge, or the divergence, said last; empty when content
  int cycles = 0;
};

/// weights times caution.
void use_caution(const Caution& caution, const fmg::RelaxationParameters& weights, fmg::RelaxationParameters& used);

struct Verdict {
  std::string unmet;         ///< what is wrong with the state; empty when nothing
  bool no_solution = false;  ///< more cycles cannot mend it
};
/// Looks at the states before and after a cycle (numbered from 1).
using Judge = std::function<Verdict(int cycle, const StateOfLevel& before, const StateOfLevel& after)>;

/// FAS cycles on level l, from the state that is there, at most `most`.
/// Backs off: without relaxations after the correction, a residual that falls slowly adds one to the hierarchy's
/// parameters, for good; a residual that rises or hardly falls lowers the weight where epsilon is steep, and then all
/// weights; a state that is no longer finite, or hopeless, is replaced by the one at the beginning and all weights are
/// lowered; where that does not help the one at the beginning is what is left. in: weights, those of no caution;
/// in/out: caution, what the level below needed and what this one did.
CyclesResult run_cycles(fmg::Hierarchy& hierarchy, std::size_t l, int most, const fmg::RelaxationParameters& weights,
                        Caution& caution, const Judge& judge);

}  // namespace ehl::steady
