#pragma once
// What the solution of a grid leaves of the equations of a coarser one.
#include <cstddef>

#include "fmg/hierarchy.hpp"

namespace ehl::adjoint {

/// Parts of the coarse grid's residual at the finer solution; where P = 0 all of it is in the first. Times the weights
/// of a number they sum up to what that number changes between the two grids.
struct Truncation {
  core::Field poiseuille;  ///< of the pressure's terms
  core::Field wedge;       ///< of d(rho_bar H)/dX
  core::Field film;        ///< of the deformation's quadrature, by what it changes in both
  double load = 0.0;       ///< carried less wanted, of the sum of P
};

/// out: levels[coarse] is the level being solved, in the state of levels[fine] at its nodes, with its own film.
/// in: levels[fine] solved, with its film; coarse < fine.
Truncation truncation(fmg::Hierarchy& hierarchy, std::size_t coarse, std::size_t fine);

}  // namespace ehl::adjoint
