#pragma once
// Krylov acceleration of slow cycles.
#include <vector>

#include "core/field.hpp"
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// The last states of a series of cycles on one level, and their combination with the smallest residual. Slow cycles
/// leave errors in few places, at the edge of a spike whose flank is one cell wide. These are few modes, which a
/// combination of states removes.
/// Source: Washio and Oosterlee, Krylov subspace acceleration for nonlinear multigrid schemes, ETNA 6 (1997).
class Acceleration {
 public:
  /// Stores the state of levels[l]. in: r of the level belongs to its state. cost: copies a pressure and a residual;
  /// the first calls allocate.
  void remember(const Hierarchy& hierarchy, std::size_t l);
  /// Writes the state P + sum alpha_k (P_k - P), and H00 in the same manner, where P and r are those of the level and
  /// P_k and r_k the stored ones. The alpha_k minimize the root mean square of (r + sum alpha_k (r_k - r))/d over the
  /// nodes whose pressure may change; d is the derivative of r by the node's own pressure. in: r of the level belongs
  /// to its state. out: false if nothing is stored or no finite alpha exists.
  bool combine(const Hierarchy& hierarchy, std::size_t l, State& combined);
  void forget() { kept_.clear(); }

 private:
  struct Kept {
    State state;
    core::Field asked;
  };
  std::vector<Kept> kept_;  ///< the oldest first
  core::Field asked_;       ///< of the level's present state
};

}  // namespace ehl::multigrid
