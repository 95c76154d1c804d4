#pragma once
// Adjoint solutions: the derivative of a number such as Hc or Hm by the residual at each node.
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "judgement/fitted_minimum.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/hierarchy.hpp"
#include "newton/equations.hpp"
#include "newton/preconditioner.hpp"
#include "newton/slopes.hpp"

namespace ehl::adjoint {

/// A number that is a weighted sum of nodal films.
using Number = std::vector<judgement::NodeWeight>;
double value_of(const Number& number, const core::Field& film);

/// The adjoint solution of a number. To first order the number at a state minus that at the solution is
///   sum residual r + sum pressure P + load (carried - prescribed) + sum boundary (P - P of the far field).
/// Fields are on the patch; a mirrored node counts for both.
struct Weights {
  core::Field residual;  ///< at nodes that have P > 0 in the predicted solution; else zero
  core::Field pressure;  ///< at nodes that have P = 0 there; else zero
  double load = 0.0;
  std::vector<double> boundary;  ///< in the order of multigrid::nodes_of_boundary; empty without a far field
};
/// The sum of the first three terms. in: r, P and carried - prescribed load of the state.
double left_over(const Weights& weights, const core::Field& r, const core::Field& P, double load);

/// The transposed Jacobian of a level's equations, with complementarity, force balance and far field: one linear system
/// gives the adjoint solution of one number.
class Adjoint {
 public:
  /// in: levels[l] as the level being solved (multigrid::start_from_state), with its residual. If its state is not the
  /// solution the adjoint solution has an error of first order in the difference. cost: 17 evaluations of the equations
  /// without the deformation, and a sparse LU.
  Adjoint(multigrid::Hierarchy& hierarchy, std::size_t l);

  /// The adjoint solution to a relative tolerance, by GMRES; none if the tolerance is not reached. K is taken as
  /// symmetric, which holds up to the accuracy of its evaluation. cost: one deformation per iteration.
  std::optional<Weights> weights(const Number& number, double tolerance);
  int iterations() const { return iterations_; }

 private:
  void scatter(const newton::Slopes& slopes, std::span<const double> x, core::Field& y) const;
  void deform(core::Field& v);
  void product(std::span<const double> x, std::span<double> y);

  multigrid::Hierarchy& hierarchy_;
  multigrid::Level& level_;
  newton::Equations equations_;
  newton::Preconditioner preconditioner_;
  newton::Slopes by_P_, by_H_;
  std::vector<multigrid::BoundaryNode> boundary_;
  multigrid::FarSlopes far_;
  core::Field on_P_, on_H_, deformed_;
  bool factored_ = false;
  int iterations_ = 0;
};

}  // namespace ehl::adjoint
