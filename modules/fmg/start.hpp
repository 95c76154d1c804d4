#pragma once
// The way up of the full multigrid: a first solution on a coarse grid, and better ones from level to level.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

// The level being solved has the right-hand sides of the original problem: f = 0, and F = S, its own mean of what the
// surfaces add to the gap. As a coarse grid of a finer level it has those of the full approximation scheme.

/// Makes levels[l] the level being solved, from the dry contact: P = sqrt(1 - X^2 - Y^2) inside the Hertz circle, or
/// the like of an ellipse, H00 as given less the mean of S under that pressure, which lifts the bodies apart; then
/// `sweeps` relaxations with the force balance (eq. 26) after every fourth. errors: core::SolverError.
void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps, const Parameters& how);
inline void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps) {
  start_from_hertz(hierarchy, l, H00, sweeps, hierarchy.parameters);
}

/// Makes levels[l] the level being solved, from a state given. in: P of the level's shape.
void start_from_state(Hierarchy& hierarchy, std::size_t l, const State& start);

/// Makes levels[l] the level being solved, from the solution on levels[l-1] by bicubic interpolation held at P >= 0.
void start_from_coarser(Hierarchy& hierarchy, std::size_t l);

/// The same from the solutions on levels[l-1] and levels[l-2]: what changed from the coarser to the finer one, divided
/// by 2^order, is what will change next, where the discretization error falls with that order. The start is three to
/// ten times closer to the solution. in: two_below, the solution on levels[l-2]; order > 0.
void start_from_two_coarser(Hierarchy& hierarchy, std::size_t l, const State& two_below, double order);

}  // namespace ehl::fmg
