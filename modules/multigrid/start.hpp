#pragma once
// Initial states of the full multigrid solve: of the first grid, and of each finer one from the solutions below it.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

// The level being solved has the right-hand sides of the original problem: f = 0, and F = S as far as this grid
// resolves it. A coarse grid of a finer level has those of the full approximation scheme.

/// Makes levels[l] the level being solved, from the dry contact: P = sqrt(1 - X^2 - Y^2) inside the Hertz circle, or
/// its equal for an ellipse, and H00 as given less the mean of S under that pressure, by which the relief lifts the
/// bodies. Then `sweeps` relaxations, with the force balance (eq. 26) after every fourth, and with epsilon at half
/// points a few cycles. errors: core::SolverError.
void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps, const Parameters& how);
inline void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps) {
  start_from_hertz(hierarchy, l, H00, sweeps, hierarchy.parameters);
}

/// Makes levels[l] the level being solved, from a given state. in: P of the level's shape.
void start_from_state(Hierarchy& hierarchy, std::size_t l, const State& start);

/// Makes levels[l] the level being solved, from the solution on levels[l-1] by bicubic interpolation, with P >= 0.
void start_from_coarser(Hierarchy& hierarchy, std::size_t l);

/// Makes levels[l] the level being solved, by extrapolation from the solutions on levels[l-1] and levels[l-2]. Where
/// the discretization error falls with the given order, the next change is that from levels[l-2] to levels[l-1],
/// divided by 2^order. The start is closer to the solution. [bench: extrapolated_start] in: two_below, the solution on
/// levels[l-2]; order > 0. P and H00 of levels[l-1] are overwritten by the extrapolated ones.
void start_from_two_coarser(Hierarchy& hierarchy, std::size_t l, const State& two_below, double order);

}  // namespace ehl::multigrid
