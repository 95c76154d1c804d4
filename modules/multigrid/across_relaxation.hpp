#pragma once
// The Y sweep: relaxation along Y of the points that epsilon couples strongly.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// The Y sweep. On cells with hx > hy a node is coupled to its neighbours along Y (hx/hy)^2 times as strongly as to
/// those along X, with which it is relaxed together. At the side of a contact epsilon falls by orders from line to
/// line, so that the errors there are smooth on no grid, and cycles with X sweeps alone are slow. [bench: y_sweep]
///
/// Therefore the single points are relaxed once more, all of a column (constant X) together: rows of d r/dP over j-1,
/// j, j+1 with epsilon following these pressures, and the film by K(0, 0) and K(0, 1). Odd columns come first, then
/// even ones. Epsilon must follow the pressure: the flux down a flank that is one cell wide depends so strongly on the
/// pressure at its foot that the sweep diverges with epsilon held.
///
/// H stays as it is during the sweep. in: P, H and their coefficients. out: P; the caller renews the film.
void relax_across(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

/// False for line contacts, in time, and with the mass-conserving cavitation model.
bool can_relax_across(const Hierarchy& hierarchy, const Level& level);

}  // namespace ehl::multigrid
