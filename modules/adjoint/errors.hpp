#pragma once
// The errors of Hc and Hm that a solution has, foretold by the weights of what is left of its equations.
#include <cstddef>
#include <optional>

#include "fmg/hierarchy.hpp"

namespace ehl::adjoint {

/// Of one number, relative to it.
struct Foretold {
  // What it changes from the grid of half as many cells to this one, by the terms that change it (truncation.hpp).
  double poiseuille = 0.0;
  double wedge = 0.0;
  double film = 0.0;       ///< the sum of P, and the fit of the minimum, included
  double left = 0.0;       ///< the number less that of the solved equations, by the residual of the last cycle
  double scattered = 0.0;  ///< the same without regard to sign: of a residual that changes its sign from node to node
  /// What the far field on the boundary may be wrong by, whatever its sign; 0 where it is not closed.
  double domain = 0.0;
  double change() const { return poiseuille + wedge + film; }
};

struct Errors {
  Foretold Hc, Hm;  ///< Hm: the fitted minimum
  int cells = 0;    ///< along x of the grid of the weights
  /// Where the error is made: what the pressure's terms and the wedge at a place do to the number, relative and per
  /// unit area, by their orders. On the finest grid's domain; empty where no maps are asked for. (The deformation's
  /// part is one with H00's and has no place.)
  core::Field map_Hc{}, map_Hm{};
  double seconds = 0.0;
};

/// Of the finest grid as it was solved. The weights are those of a grid with four times its mesh size, eight times
/// where that has more than 6000 nodes: there they are larger by a fifth to a half, and cost a tenth of the cycles.
/// None with a single grid, or where they are not found. out: the finest level and H00 as they were; those below have
/// other states.
std::optional<Errors> errors(fmg::Hierarchy& hierarchy, bool maps = false);

}  // namespace ehl::adjoint
