#pragma once
// Adjoint (dual-weighted residual) estimates of the errors of Hc and Hm.
#include <cstddef>
#include <optional>

#include "multigrid/hierarchy.hpp"

namespace ehl::adjoint {

/// Predicted changes of one number, relative to it.
struct PredictedChange {
  // Change from the grid of half as many cells to this one, by the terms that cause it (truncation.hpp).
  double poiseuille = 0.0;
  double wedge = 0.0;
  double film = 0.0;       ///< the deformation, with the sum of P and the fit of the minimum
  double left = 0.0;       ///< algebraic error, by the residual of the last cycle
  double scattered = 0.0;  ///< sum of the absolute terms of `left`, in which an alternating residual cancels
  /// Bound on the error from the far field on the boundary; 0 if that is not in closed form.
  double domain = 0.0;
  double change() const { return poiseuille + wedge + film; }
};

struct Errors {
  PredictedChange Hc, Hm;  ///< Hm: the fitted minimum
  int cells = 0;           ///< cells along x of the grid of the adjoint solution
  /// Maps of where the error arises: the contribution of the pressure terms and the wedge to the number, relative and
  /// per unit area, each extrapolated by its order. On the finest grid's domain; empty if not requested. The
  /// contribution of the deformation acts through H00 and has no place.
  core::Field map_Hc{}, map_Hm{};
  double seconds = 0.0;
};

/// Estimates the errors of the finest grid's present state. The adjoint solution is that of a grid with four times its
/// mesh size, or eight times if that grid has many nodes. [bench: many_nodes]
/// out: none with a single grid, or if the adjoint system is not solved. The finest level and H00 are unchanged; the
/// states of the coarser levels are overwritten.
std::optional<Errors> errors(multigrid::Hierarchy& hierarchy, bool maps = false);

}  // namespace ehl::adjoint
