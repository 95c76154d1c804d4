#pragma once
// How fine a grid must be, before anything is known of the solution but its load and shape. M and L are those of
// contact/groups.hpp, with R_x; films and lengths are in a^2/R_x and a.
#include "contact/ellipse.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::steady {

/// The central film H = h R/a^2 to expect: the formula of Nijenbanning, Venner and Moes, good to 15 %; aslant that of
/// both components of the speed together, 8 to 25 % above our own solutions for R_x/R_y = 0.005 to 0.2 at 45 degrees,
/// M = 20 to 1000.
/// in: M > 0, L >= 0.
double expected_central_film(double M, double L, const contact::Ellipse& shape = {});

/// The load M of the circular contact of the same oil and speed whose film is as thick over its mutual approach: how
/// heavily loaded a contact of any shape is. in: M > 0, L >= 0. out: M itself for a circle.
double circular_load(double M, double L, const contact::Ellipse& shape);

/// The minimum film H = h R/a^2 to expect, within a factor 1.5: the central film of Nijenbanning, Venner and Moes
/// times the share of it that our own solutions have at its thinnest, 0.6 (M/50)^(-1/5), half as much again where the
/// lubricant is isoviscous, and at most 0.9. Of a line 0.8 of the central film: 0.79 to 0.89 for M = 2 to 50.
/// in: M > 0, L >= 0 (contact/groups.hpp).
double expected_least_film(double M, double L, const contact::Ellipse& shape = {});

/// Size of the region where pressure is made, in Hertz radii: 1, or sqrt(2 Hc) where the film is so thick that the
/// contact is nearly rigid; Hc by the same formula. Of an ellipse along X. in: M > 0, L >= 0.
double contact_size(double M, double L, const contact::Ellipse& shape = {});

/// How much longer the region where pressure is made is along X than across its shorter side, flattened or nearly
/// rigid: so many times more cells along X hold the contact as well as a circular one. out: >= 1; 1 for a circle.
double slenderness(double M, double L, const contact::Ellipse& shape);

/// The gap beside the edge of the dry contact, which grows as the power 3/2 of the distance, over that beside a circle:
/// where the edge is steepest, at the ends of the shorter axis. out: 1 for a circle.
double edge_steepness(const contact::Ellipse& shape);

/// Width of the zones at inlet and outlet in which the film is made, in Hertz radii: Hm^(2/3), Hm the film to expect,
/// since the gap beside a flattened contact grows as the power 3/2 of the distance; where the edge is steepest.
/// in: M > 0, L >= 0.
double film_zone(double M, double L, const contact::Ellipse& shape = {});

/// Mesh size along X, in Hertz radii, that resolves the film: 0.3 film_zone and at most 0.4 of contact_size along the
/// shorter axis; for the first-order wedge 0.2 and 0.2. The error of the second-order wedge is about 0.4
/// (hx/film_zone)^2 in Hm. Of cells that are longer along X, the mesh size across. in: M > 0, L >= 0.
double resolving_step(double M, double L, reynolds::Wedge wedge, const contact::Ellipse& shape = {});

/// hy/hx of the cells. Of a contact that reaches more than seven times as far across the motion as along it, 2: along Y
/// all changes slowly there. Of five such contacts (R_x/R_y = 0.03 and 0.01) Hc and Hm then move by less than 7e-5 of
/// themselves, cycles leave less of the residual, and take half the time; with 4, one in five takes a second start.
/// Of one that reaches more than six times as far along the motion, the largest of 1/2, 1/4, 1/8 that is 1.6 times as
/// wide as the contact's own shape or more. In units of its own semi-axes such a contact is a circle: the strips at the
/// sides, where the film is thinnest, get as many cells as the ends with cells of that shape. The spike at the outlet
/// end wants more along X: R_x/R_y = 50, (20, 15), is solved with 1/4 and diverges there with 1/8. Not aslant, where
/// the spike of the outlet crosses the lines: R_x/R_y = 37.8, (36.1, 11.8), leaves 0.3 per cycle at 1 to 5 degrees;
/// with 1/8 and 1/4 0.31, 0.61, 0.67 at 1, 2, 3 degrees, and at 5 no end.
/// out: 1 of all others.
double cell_aspect(const contact::Ellipse& shape);
/// More than six times as long along the motion, or aslant of it, as wide.
bool long_along_motion(const contact::Ellipse& shape);

/// Cells along x of at most this mesh size on this length of domain: `fewest`, doubled as often as it takes and as
/// `most` allows.
int resolving_cells(double step, double length, int fewest, int most);

}  // namespace ehl::steady
