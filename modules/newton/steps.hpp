#pragma once
// Single Newton steps, for a caller that judges the states itself: the implicit time steps.
#include <vector>

#include "multigrid/hierarchy.hpp"
#include "newton/equations.hpp"
#include "newton/preconditioner.hpp"
#include "newton/tuning.hpp"

namespace ehl::newton {

/// Semismooth Newton steps on the finest level as it is posed: with right-hand sides f and F, with squeeze, and with a
/// load that grows with H00. The factors of one step are reused in later steps and problems as long as GMRES converges
/// quickly with them. limits: the oil content is no unknown; positive load. cost: the factors of a line contact grow
/// with the third power of its nodes, a step with their square.
class Steps {
 public:
  /// in: a hierarchy that outlives this object.
  explicit Steps(multigrid::Hierarchy& hierarchy, const Tuning& tuning = {});

  /// One step from the level's state. It changes no pressure by more than Tuning::longest_change and the film at the
  /// centre by no more than a share of itself; the far field is updated. out: false if the linear system is not solved.
  /// errors: core::SolverError of the far field.
  bool take();

 private:
  bool factor();
  void precondition(std::span<double> v);
  void apply();

  multigrid::Hierarchy& hierarchy_;
  const Tuning tuning_;
  Equations equations_;
  Preconditioner preconditioner_;
  std::vector<double> u_, minus_F_, change_;
  std::vector<double> scale_of_factors_;  ///< row scales when the factors were made; empty: no factors
};

}  // namespace ehl::newton
