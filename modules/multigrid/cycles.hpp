#pragma once
// Cycles on one level until a criterion holds, with stronger damping if they do not reduce the residual.
#include <cstddef>
#include <functional>
#include <string>

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
  Damping damping{};            ///< damping at the end
  judgement::LastCycle last{};  ///< the last one that was judged
};

/// FAS cycles on level l, from its present state, until the criterion holds; with Aim::solution and the mass-conserving
/// cavitation model until the global oil balance holds as well. Remedies:
/// - a slow cycle (Tuning::rough_factor): a relaxation after the correction if there is none, else on square cells a Y
///   sweep and, above the first grid, weighted corrections and W cycles; from then on Krylov acceleration
///   (acceleration.hpp), where can_relax_across() [bench: krylov_states];
/// - a residual that rises or hardly falls: a smaller weight where epsilon is steep, then smaller weights everywhere;
/// - a state that is not finite, or hopeless: back to the initial state, with smaller weights everywhere; if none of
///   them help, the level is left in its initial state;
/// - fast cycles on stretched cells: a larger weight where epsilon is steep.
/// in: the initial damping.
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
