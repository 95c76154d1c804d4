#pragma once
// Cycles on one level until a criterion is met, with more caution where they do not reduce the residual.
#include <cstddef>
#include <functional>
#include <string>

#include "fmg/record.hpp"
#include "judgement/stopping.hpp"

namespace ehl::fmg {

/// A cycle without relaxations after the correction that leaves more of the residual than this gets one. Such cycles
/// leave 0.2 to 0.3 where they work, those with one 0.1 to 0.2 for a third more work.
inline constexpr double rough_factor = 0.4;

/// How much more carefully than the parameters say.
struct Caution {
  double all = 1.0;          ///< factor on every under-relaxation weight
  double steep = 1.0;        ///< once more on that of single changes where epsilon differs by orders from cell to cell
  bool relax_after = false;  ///< a relaxation after the correction, where there would be none
};
Parameters cautious(const Parameters& parameters, const Caution& caution);

/// Estimated relative discretization error of a level; NaN where unknown.
struct DiscretizationError {
  double Hc = 0.0;
  double Hm = 0.0;
};
/// Is told of the state after every cycle (numbered from 1), and tells what is known of the level's error.
using CycleObserver = std::function<DiscretizationError(int cycle, const judgement::Measures& now)>;

struct CyclesResult {
  CyclesEnd end = CyclesEnd::content;
  std::string unmet{};  ///< what the criterion, or the divergence, said last; empty when content
  int cycles = 0;
  Caution caution{};            ///< that was needed in the end
  judgement::LastCycle last{};  ///< that was judged
};

/// FAS cycles on level l, from the state that is there, until the criterion is met; with Aim::solution where mass is
/// conserved, until the oil balances as well.
/// Backs off: without relaxations after the correction, a residual that falls slowly asks for one; a residual that
/// rises or hardly falls lowers the weight where epsilon is steep, and then all weights; a state that is no longer
/// finite, or hopeless, is replaced by the one at the beginning and all weights are lowered; where that does not help
/// the one at the beginning is what is left. On stretched cells good cycles raise the weight where epsilon is steep.
/// Where relaxations follow the correction already, a residual that falls slowly asks for relaxation across, too. From
/// the first cycle that leaves more than rough_factor on, the states are combined (acceleration.hpp): of (20, 15) at
/// R_x/R_y = 20, 50 and 100 cycles leave 0.33, 0.43, 0.49, without 0.40, 0.61, 0.55. in: caution, to begin with.
CyclesResult run_cycles(Hierarchy& hierarchy, std::size_t l, const judgement::StoppingCriterion& criterion,
                        const Caution& caution, const CycleObserver& observe);

/// Closes the oil of a state that is a solution in all else (close_oil(), oil.hpp), and leaves it as it was where the
/// closed one is none. in: `before`, the state before the last cycle; judge(), of the state that `now` was measured of.
/// out: what it says of the closed state; else what the oil lacks.
judgement::Verdict close_or_leave(Hierarchy& hierarchy, std::size_t l, const State& before,
                                  const RelaxationParameters& relaxation, judgement::Measures& now,
                                  const std::function<judgement::Verdict()>& judge);

/// Measures levels[l]; makes its residual anew.
judgement::Measures measures_of(Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::fmg
