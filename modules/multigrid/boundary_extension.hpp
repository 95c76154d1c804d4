#pragma once
// Extension of a new boundary pressure into the domain.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// Extends changes of the boundary pressure into the domain where epsilon is large. Along a row of nodes the flux of
/// the change, epsilon times its gradient, is constant, and the change falls to zero where the response of the film is
/// as strong as the coupling to the next node, or at the first cavitated node. First along Y; then along X, with what
/// this leaves of the changes on the inlet and the outlet.
/// in: level.correction, the changes, on the boundary alone; P, which contains them there. out: P; the correction
/// inside is overwritten, the film is not renewed.
void extend_boundary(const Hierarchy& hierarchy, Level& level);

}  // namespace ehl::multigrid
