#pragma once
// Krylov acceleration of cycles that leave much of the residual.
#include <vector>

#include "core/field.hpp"
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// The last states of a series of cycles on one level. Cycles are slow by what few places leave of them, at the rim of
/// a spike whose flank is one cell wide: few modes, which a combination of states takes away.
/// Source: Washio and Oosterlee, Krylov subspace acceleration for nonlinear multigrid schemes, ETNA 6 (1997).
class Acceleration {
 public:
  /// in: levels[l], whose residual belongs to its state. cost: a pressure and a residual; allocates the first times.
  void remember(const Hierarchy& hierarchy, std::size_t l);
  /// Writes P + sum alpha_k (P_k - P) and H00 likewise, P and r of the level, P_k and r_k remembered; the alpha make
  /// (r + sum alpha_k (r_k - r))/d least in root mean square over the nodes that ask for another pressure, d what a
  /// node answers to its own.
  /// in: as above. out: false where nothing is remembered.
  bool combine(const Hierarchy& hierarchy, std::size_t l, State& combined);
  void forget() { kept_.clear(); }

 private:
  struct Kept {
    State state;
    core::Field asked;
  };
  std::vector<Kept> kept_;  ///< the oldest first
  core::Field asked_;       ///< of the state that is there
};

}  // namespace ehl::fmg
