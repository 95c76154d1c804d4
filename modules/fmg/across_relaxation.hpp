#pragma once
// Relaxation across X of what epsilon couples.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// On cells hx > hy a node is coupled to its neighbours across (hx/hy)^2 times as strongly as along the lines that are
/// relaxed together. At the side of a contact epsilon falls by orders from line to line, a spike's top and its flank
/// are neighbours across, and what is left there is smooth on no grid: with lines along X alone cycles leave 0.5 to
/// 0.7. So the nodes that change singly are relaxed once more, all of a station together: the rows d r/dP over j-1, j,
/// j+1 with epsilon as it follows these pressures, and the film by K(0, 0) and K(0, 1); odd stations, then even ones.
/// With epsilon held a spike whose flank is one cell wide swings: at the tip behind the contact (20, 15) at R_x/R_y =
/// 100 each pass left -2 of it, for the flux down the flank answers ten times as much to the pressure at its foot. H
/// and epsilon are those it begins with. in: P, and H and the coefficients that belong to it. out: P; the film is left
/// to renew.
void relax_across(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

/// False of a line, in time, and where dry points hold oil of their own.
bool can_relax_across(const Hierarchy& hierarchy, const Level& level);

}  // namespace ehl::fmg
