#pragma once
// Newton's steps one by one, for a caller who judges the states himself: the implicit steps of time.
#include <vector>

#include "fmg/hierarchy.hpp"
#include "newton/equations.hpp"
#include "newton/preconditioner.hpp"

namespace ehl::newton {

/// Semismooth Newton steps on the finest level as it is posed: with right-hand sides f and F, with squeeze, with a load
/// that grows with H00. The factors of one step serve the next ones, of later problems too, for as long as GMRES is
/// quick with them. limits: no content as an unknown; a load above zero. cost: the factors of a line contact grow with
/// the third power of its nodes, a step with their square.
class Steps {
 public:
  /// in: a hierarchy that outlives this object.
  explicit Steps(fmg::Hierarchy& hierarchy);

  /// From the state that the level holds to the next one, no pressure changed by more than 0.3 and the film at the
  /// centre by no more than a share of itself; the far field follows. out: false where the linear system is not solved.
  /// errors: core::SolverError of the far field.
  bool take();

 private:
  bool factor();
  void precondition(std::span<double> v);
  void apply();

  fmg::Hierarchy& hierarchy_;
  Equations equations_;
  Preconditioner preconditioner_;
  std::vector<double> u_, minus_F_, change_;
  std::vector<double> scale_of_factors_;  ///< of the rows; empty: no factors
};

}  // namespace ehl::newton
