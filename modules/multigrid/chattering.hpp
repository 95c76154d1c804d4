#pragma once
// Chattering nodes at the edge of the film, in the mass-conserving cavitation model. The second-order flux downstream
// of a node depends on whether the node is full. A node that empties while it is full, and fills while it is not,
// changes for ever. Downstream of such a node the flux is of first order in either state, and a solution exists.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// Compares which nodes are full with the last call, and marks those that chatter. A node without pressure may be full.
/// out: how many this call has marked; 0 without the mass-conserving model.
int mark_chattering(const Tuning& tuning, Level& level);

/// Marks the nodes that chatter from one relaxation to the next, in a state that cycles no longer improve: a node may
/// change within every cycle and be of the same kind after each. (Far from a solution relaxations change nodes that do
/// have a state as well.) out: how many were marked; the relaxed state if there are any, else the state of before.
int find_chattering(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

/// Removes all marks and counts.
void forget_chattering(Level& level);

/// Number of marked nodes, in both halves of a symmetric problem.
int chattering_nodes(const Level& level);

}  // namespace ehl::multigrid
