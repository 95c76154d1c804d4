#pragma once
// How much what is left of the discrete equations, at each node, changes a number such as Hc or Hm.
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fmg/boundary.hpp"
#include "fmg/hierarchy.hpp"
#include "judgement/fitted_minimum.hpp"
#include "newton/equations.hpp"
#include "newton/preconditioner.hpp"
#include "newton/slopes.hpp"

namespace ehl::adjoint {

/// A number that is made of the film.
using Number = std::vector<judgement::NodeWeight>;
double value_of(const Number& number, const core::Field& film);

/// To first order, a number of a state less the same of the solution is
///   sum residual r + sum pressure P + load (carried - wanted) + sum boundary (P - P of the far field).
/// Of the patch; a mirrored node counts for both.
struct Weights {
  core::Field residual;  ///< where P > 0 in the solution, as it is foretold; else zero
  core::Field pressure;  ///< where P = 0 there; else zero
  double load = 0.0;
  std::vector<double> boundary;  ///< in the order of fmg::nodes_of_boundary; none without a far field
};
/// The first three. in: r, P and carried - wanted load of the state.
double left_over(const Weights& weights, const core::Field& r, const core::Field& P, double load);

/// The transposed slope of a level's equations, complementarity, force balance and far field included: one linear
/// system gives the weights of one number for all that may be left of the equations.
class Adjoint {
 public:
  /// in: levels[l] as the level being solved (fmg::start_from_state), r made; its state may be some way from the
  /// solution, the weights are then wrong by as much to first order. cost: 17 evaluations of the equations without the
  /// deformation, and a sparse LU.
  Adjoint(fmg::Hierarchy& hierarchy, std::size_t l);

  /// Weights to a relative tolerance, by GMRES; none where it does not get there. K^T = K but for what the evaluator of
  /// the deformation leaves of that. cost: 20 to 60 deformations.
  std::optional<Weights> weights(const Number& number, double tolerance);
  int iterations() const { return iterations_; }

 private:
  void scatter(const newton::Slopes& slopes, std::span<const double> x, core::Field& y) const;
  void deform(core::Field& v);
  void product(std::span<const double> x, std::span<double> y);

  fmg::Hierarchy& hierarchy_;
  fmg::Level& level_;
  newton::Equations equations_;
  newton::Preconditioner preconditioner_;
  newton::Slopes by_P_, by_H_;
  std::vector<fmg::BoundaryNode> boundary_;
  fmg::FarSlopes far_;
  core::Field on_P_, on_H_, deformed_;
  bool factored_ = false;
  int iterations_ = 0;
};

}  // namespace ehl::adjoint
