#pragma once
// Truncation error: the residual of a grid's solution in the equations of a coarser grid.
#include <cstddef>

#include "multigrid/hierarchy.hpp"

namespace ehl::adjoint {

/// Parts of the coarse grid's residual at the finer grid's solution; where P = 0 all of it is in `poiseuille`. Their
/// sum, weighted by the adjoint solution of a number, is the change of that number between the two grids.
struct Truncation {
  core::Field poiseuille;  ///< the pressure terms
  core::Field wedge;       ///< the wedge, d(rho_bar H)/dX
  core::Field film;        ///< the deformation's quadrature, through both terms
  double load = 0.0;       ///< carried minus prescribed load, from the sum of P
};

/// Computes the truncation error. in: levels[fine] solved, with its film; coarse < fine. out: levels[coarse] becomes
/// the level being solved, in the state of levels[fine] at its nodes, with its own film.
Truncation truncation(multigrid::Hierarchy& hierarchy, std::size_t coarse, std::size_t fine);

}  // namespace ehl::adjoint
