#pragma once
// The mesh size that resolves the film of a contact, and the shape of its cells.
#include "reynolds/wedge.hpp"
#include "steady/scales.hpp"
#include "steady/tuning.hpp"

namespace ehl::steady {

/// Mesh size along X, in Hertz radii, that resolves the film: resolving_share of the film zone, and at most
/// resolving_size of the contact's size along the shorter axis. For cells that are longer along X it is the mesh size
/// along Y. order: the error of the second-order wedge in Hm is about 0.4 (hx/film_zone)^2.
double resolving_step(const Tuning& tuning, const ContactScales& scales, reynolds::Wedge wedge);

/// Aspect ratio hy/hx of the cells. [bench: cell_aspect]
///   2 if the contact is more than seven times as wide as long in the rolling direction: it varies slowly along Y.
///   1/4, 1/8 or 1/16 if it is more than six times as long as wide: the smallest of these that is not below the
///   ratio of its axes. Scaled by its semi-axes such a contact is a circle, so that the strips at the sides, where
///   the film is thinnest, get as many cells as the ends.
///   1 for all others, and for every oblique contact, whose spike crosses the grid lines.
double cell_aspect(const Tuning& tuning, const contact::Ellipse& shape);
/// True if the contact is elongated in the rolling direction: more than six times as long as wide, in line with the
/// motion or oblique to it.
bool elongated(const Tuning& tuning, const contact::Ellipse& shape);

/// Cells along x: `fewest`, doubled until the mesh size on this length of domain is at most `step`, without exceeding
/// `most`.
int resolving_cells(double step, double length, int fewest, int most);

}  // namespace ehl::steady
