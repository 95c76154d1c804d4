#pragma once
// The numbers by which a state is judged.
#include "core/grid.hpp"
#include "fmg/hierarchy.hpp"

namespace ehl::steady {

struct StateOfLevel {
  double Hc = 0.0;          ///< H at (0,0)
  double Hm = 0.0;          ///< minimum of H over the nodes
  double residual = 0.0;    ///< relative residual of the complementarity problem
  double load_error = 0.0;  ///< relative
};

/// Value at (X, Y): the node's where there is one within 1e-9 of a cell, else by bicubic interpolation.
/// limits: (X, Y) inside the grid.
double value_at(const core::Grid& grid, const core::Field& field, double X, double Y);

/// Judges levels[l]; makes its residual anew.
StateOfLevel state_of_level(fmg::Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::steady
