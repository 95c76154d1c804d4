#pragma once
// What a new pressure on the boundary does to the pressure inside.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// Leads changes of the pressure on the boundary on to the inside, where epsilon is large: along rows of nodes epsilon
/// dP/dX of the change is the same everywhere, and the change falls to nothing where the film answers as strongly as
/// the pressure beside it, or at the first dry node. First along Y, then what is left on the inlet and the outlet along
/// X. in: level.correction, the changes, on the boundary alone; P, which has them there. Uses the correction inside.
/// The film does not follow.
void lead_inward(const Hierarchy& hierarchy, Level& level);

}  // namespace ehl::fmg
