#pragma once
// Cycles on one level until a criterion holds, with stronger damping if they do not reduce the residual.
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "judgement/stopping.hpp"
#include "multigrid/record.hpp"

namespace ehl::multigrid {

/// Damping in addition to that of the parameters.
struct Damping {
  double all = 1.0;          ///< factor on every under-relaxation weight
  double steep = 1.0;        ///< further factor on that of single changes where epsilon is steep
  bool relax_after = false;  ///< one relaxation after the correction if the parameters have none
  /// Corrections weighted by face conductances, and W instead of F cycles. A slow cycle above the first grid asks for
  /// them: the top of the spike and its flank then lie on neighbouring nodes. [bench: weighted_interpolation]
  bool weighted = false;
};
/// The parameters with this damping.
Parameters cautious(const Parameters& parameters, const Damping& damping);

/// Estimated relative discretization error of a level; NaN where unknown.
struct DiscretizationError {
  double Hc = 0.0;
  double Hm = 0.0;
};
/// Receives the measures after every cycle (numbered from 1) and returns the estimated error of the level.
using CycleObserver = std::function<DiscretizationError(int cycle, const judgement::Measures& now)>;

struct CyclesResult {
  CyclesEnd end = CyclesEnd::converged;
  std::string unmet{};  ///< the check that failed last, or how the cycles diverged; empty if converged
  int cycles = 0;
  Damping damping{};                    ///< damping at the end
  judgement::LastCycle last{};          ///< the last one that was judged
  std::vector<std::string> remedies{};  ///< what the cycles needed, by the names in cycle_control.cpp
};

/// FAS cycles on level l, from its present state, until the criterion holds; with Aim::solution and the mass-conserving
/// cavitation model until the global oil balance holds as well. After every cycle a table of rules (cycle_control.cpp)
/// says what to change for the next one. Slow cycles (Tuning::rough_factor) also ask for Krylov acceleration
/// (acceleration.hpp), where can_relax_across() [bench: krylov_states]. A cycle that ends in a state that is not
/// finite, or hopeless, is followed by a restart from the initial state with smaller weights; if none of them help, the
/// level is left in its initial state. in: the initial damping.
CyclesResult run_cycles(Hierarchy& hierarchy, std::size_t l, const judgement::StoppingCriterion& criterion,
                        const Damping& damping, const CycleObserver& observe);

/// Global mass correction (correct_mass(), mass_balance.hpp) of a state that meets every other check. It is undone if
/// the corrected state fails one. in: `before`, the state before the last cycle; judge(), the verdict on the state that
/// `now` was measured on. out: the verdict on the corrected state; where the oil still does not balance, that.
judgement::Verdict close_or_leave(Hierarchy& hierarchy, std::size_t l, const State& before,
                                  const RelaxationParameters& relaxation, judgement::Measures& now,
                                  const std::function<judgement::Verdict()>& judge);

/// Measures of levels[l]. Recomputes its residual.
judgement::Measures measures_of(Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::multigrid
