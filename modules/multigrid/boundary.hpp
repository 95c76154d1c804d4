#pragma once
// The boundary of the domain: the pressure of the far field on it, and the load outside.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// Data of the far field at the boundary nodes, in the order in which renew_boundary() visits them; empty without a far
/// field.
std::vector<reynolds::FarPoint> points_of_boundary(const Problem& problem, const core::Patch& grid);

/// The state of the far field with the motion of the bodies at H00.
reynolds::FarState far_state(const Hierarchy& hierarchy, double H00);

/// Sets the pressure on the boundary, and the load that is left for the domain, by the far field at the present H00.
/// Without a far field it does nothing. The film follows at its next evaluation. out: the largest change of a pressure,
/// or of the load over the problem's. errors: core::SolverError where the far field has no pressure. cost: some 700
/// evaluations of the far field's P for the load, and one per boundary node.
double renew_boundary(Hierarchy& hierarchy, Level& level);
/// renew_boundary() after a cycle. In a line contact, and in others if the parameters ask for it, the changes are
/// extended into the domain where epsilon is large (boundary_extension.hpp). If that is left to the next cycle, they
/// make up most of the residual. [bench: extend_boundary]
void renew_boundary_and_inside(Hierarchy& hierarchy, Level& level);
/// The load alone; the pressure on the boundary stays as it is. errors: as renew_boundary().
double renew_load_outside(Hierarchy& hierarchy, Level& level);

/// A node of the boundary, in the order of the points, and the share of its cell that lies inside the domain.
struct BoundaryNode {
  int i = 0, j = 0;
  double share = 0.0;
};
/// All boundary nodes, in the order of points_of_boundary().
std::vector<BoundaryNode> nodes_of_boundary(const core::Patch& grid);

/// Derivatives of the far field by the film on the boundary and by H00.
struct FarSlopes {
  std::vector<double> P_by_H, P_by_H00;  ///< on the boundary
  double load_by_H00 = 0.0;              ///< of the load outside the domain
};
/// Central differences at the state of the level. limits: the problem has a far field.
FarSlopes far_slopes(const Hierarchy& hierarchy, const Level& level);

/// Implicit time step, within a cycle: the boundary pressure follows a change of H00, which is a change of the approach
/// velocity. In a steady problem it does nothing; renew_boundary() after the cycle suffices. In time a boundary
/// pressure and a load outside (see Hierarchy::outside_line) that change only at the end of a cycle are amplified from
/// cycle to cycle. [bench: follow_H00]
void follow_H00(const Hierarchy& hierarchy, Level& level);

}  // namespace ehl::multigrid
