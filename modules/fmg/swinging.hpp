#pragma once
// Nodes at the edge of the film that find no state. The second-order flux behind a node asks whether that is full;
// where it is emptied by being full and filled by being dry, it swings for ever. Behind such a node the flux is of
// first order, full or not, and there is a solution.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// Changes of its kind, from step to step of Newton's method, after which a node counts as one that swings.
/// (Relaxations flip nodes that have a state as well, up to 96 of a thin layer's edge.)
inline constexpr int changes_of_swinging = 4;

/// Compares which nodes are dry with the last call, and marks those that swing. out: how many were marked now.
/// limits: of the mass conserving model; else nothing to do.
int mark_swinging(Level& level);

/// Forgets all of it.
void forget_swinging(Level& level);

/// Nodes that are marked, those of both halves.
int swinging_nodes(const Level& level);

}  // namespace ehl::fmg
