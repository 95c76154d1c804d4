#pragma once
// The boundary of the domain: the far field's pressure on it, and its load outside.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// The far field at the nodes of the boundary, in the order in which renew_boundary goes; none without a far field.
std::vector<reynolds::FarPoint> points_of_boundary(const Problem& problem, const core::Patch& grid);

/// The pressure on the boundary and the load that is left for the inside, by the far field at the present H00; nothing
/// without one. The film follows with its next evaluation. out: the largest change of a pressure, or of the load over
/// the problem's. errors: core::SolverError where the far field has no pressure there. cost: some 700 evaluations of P
/// of the far field, and one a node.
double renew_boundary(Hierarchy& hierarchy, Level& level);
/// The same behind a cycle; where epsilon is large the pressure inside follows, of lines and where the parameters ask
/// for it. Along a line contact's inlet, left to the next cycle, a change there by 1e-10 was nine tenths of the
/// residual of this one; at R_x/R_y = 20, (1000, 15), the boundary's was as much.
void renew_boundary_and_inside(Hierarchy& hierarchy, Level& level);
/// The load alone; the pressure on the boundary stays as it is.
double renew_load_outside(Hierarchy& hierarchy, Level& level);

/// A node of the boundary, in the order of the points, and the share of its cell that lies inside.
struct BoundaryNode {
  int i = 0, j = 0;
  double share = 0.0;
};
std::vector<BoundaryNode> nodes_of_boundary(const core::Patch& grid);

/// What changes of the film there and of H00 change of a far field.
struct FarSlopes {
  std::vector<double> P_by_H, P_by_H00;  ///< on the boundary
  double load_by_H00 = 0.0;              ///< of the load beyond it
};
/// By differences, at the state of the level. limits: a problem with a far field.
FarSlopes far_slopes(const Hierarchy& hierarchy, const Level& level);

/// Within a cycle of an implicit step of time: what a change of H00, which is one of the velocity, does to the pressure
/// on the boundary. Steady: nothing, renew_boundary behind the cycle is enough. Left to the end of a cycle in time,
/// both it and the load outside, for which Hierarchy::outside_line stands, would come back multiplied from squeeze = 20
/// on.
void follow_H00(const Hierarchy& hierarchy, Level& level);

}  // namespace ehl::fmg
