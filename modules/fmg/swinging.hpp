#pragma once
// Nodes at the edge of the film that find no state. The second-order flux behind a node asks whether that is full;
// where it is emptied by being full and filled by being dry, it swings for ever. Behind such a node the flux is of
// first order, full or not, and there is a solution.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// Changes of its kind, from step to step, after which a node counts as one that swings.
inline constexpr int changes_of_swinging = 4;

/// Residuals between which nodes at the edge of the film swing, 1e-4 to 2e-2: below they flip by rounding, above they
/// are on their way.
inline bool may_swing(double residual) { return residual > 1e-7 && residual < 5e-2; }

/// Compares which nodes are full with the last call, and marks those that swing. A node without pressure may be full.
/// out: how many were marked now. limits: of the mass conserving model; else nothing to do.
int mark_swinging(Level& level);

/// The same of relaxations, a few one by one, of a state that cycles no longer improve: a node may change within each
/// cycle, and be of the same kind behind them all. (On their way relaxations flip nodes that have a state as well, up
/// to 96 of a thin layer's edge.) out: how many were marked; the relaxed state where any was, else that before.
int find_swinging(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

/// Forgets all of it.
void forget_swinging(Level& level);

/// Nodes that are marked, those of both halves.
int swinging_nodes(const Level& level);

}  // namespace ehl::fmg
