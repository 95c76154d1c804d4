#pragma once
// What a series of cycles changes if its cycles diverge, are slow, no longer improve the state, or are fast.
#include <limits>
#include <string>
#include <vector>

#include "multigrid/cycles.hpp"

namespace ehl::multigrid {

/// A series of cycles on one level: how the next cycle is done, and how the last ones went.
struct CycleSeries {
  Hierarchy& hierarchy;
  std::size_t l;
  const judgement::StoppingCriterion& criterion;

  // The next cycle
  Damping damping{};
  bool across = false;  ///< with a Y sweep
  /// Factor on the steep weight on stretched cells, which is small at first for states far from the solution. The first
  /// poor cycle ends its growth for good, since weights that rise and fall spoil the Krylov acceleration.
  double growth = 1.0;
  bool grows = true;
  Parameters how{};  ///< what follows from these and the parameters of the hierarchy

  // The last cycles
  int cycles = 0;
  State start{};                                                ///< before the first of them
  judgement::Measures before{}, now{};                          ///< before and after the last one
  double two_before = std::numeric_limits<double>::infinity();  ///< residual two cycles before the last state
  std::vector<double> residuals{};                              ///< since the last change
  int not_full = 0, not_full_before = 0;  ///< number of such nodes after the last cycle and the one before
  bool flips = false;                     ///< the meniscus is back where it was two cycles before
  std::vector<std::string> remedies{};    ///< names of the rules that changed something

  Level& level() const { return hierarchy.levels[l]; }
  const Tuning& tuning() const { return hierarchy.parameters.tuning; }
};

/// A series that begins with the present state of levels[l]. Recomputes its residual.
CycleSeries begin_series(Hierarchy& hierarchy, std::size_t l, const judgement::StoppingCriterion& criterion,
                         const Damping& damping);

/// True if a cycle reduced the residual too little.
bool slow(const CycleSeries& series);

/// After a cycle that diverged and whose initial state is restored: increases the damping. out: false if it is at its
/// limit.
bool restart(CycleSeries& series);

/// Notes the residual and the meniscus of the last cycle.
void note_cycle(CycleSeries& series);

/// Asks the rules (cycle_control.cpp) what to change for the next cycle. in: noted. out: false if the cycles should
/// end, because the residual no longer falls.
bool follow_rules(CycleSeries& series);

/// Adds a name to a list that does not have it.
void note(const std::string& name, std::vector<std::string>& list);

}  // namespace ehl::multigrid
