#pragma once
// Estimates of film thickness and of the mesh size that resolves it, from load, speed and shape alone. M and L are
// those of contact/groups.hpp, made with R_x; films are in a^2/R_x, lengths in a.
#include "contact/ellipse.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::steady {

/// Expected central film H = h R/a^2 by the formula of Nijenbanning, Venner and Moes, good to 15 %. For an oblique
/// contact the films of both components of the speed are combined; the result is up to 25 % too thick.
/// in: M > 0, L >= 0.
double expected_central_film(double M, double L, const contact::Ellipse& shape = {});

/// Load parameter M of the circular contact with the same oil and speed and the same ratio of film thickness to mutual
/// approach. It measures how heavily a contact of any shape is loaded. in: M > 0, L >= 0. out: M itself for a circle.
double circular_load(double M, double L, const contact::Ellipse& shape);

/// Expected minimum film H = h R/a^2, within a factor of 1.5: the central film times min(0.9, s (M/50)^(-1/5)), with M
/// of circular_load(). s is 0.6 for a piezoviscous and 0.9 for an isoviscous lubricant, fitted to own solutions, and
/// smaller beside slender contacts. For a line contact it is 0.8 of the central film.
/// in: M > 0, L >= 0 (contact/groups.hpp).
double expected_least_film(double M, double L, const contact::Ellipse& shape = {});

/// Half the length along X of the region of pressure, in Hertz radii: that of the dry contact, or sqrt(2 Hc) if the
/// film is so thick that the bodies are nearly rigid. Hc is expected_central_film(). in: M > 0, L >= 0.
double contact_size(double M, double L, const contact::Ellipse& shape = {});

/// Length along X of the region of pressure over its shorter width, for flattened and nearly rigid bodies. This is the
/// factor by which the contact needs more cells along X than a circle does. out: >= 1; 1 for a circle.
double slenderness(double M, double L, const contact::Ellipse& shape);

/// Steepness of the gap outside the edge of the dry contact, relative to a circle, where the edge is steepest: at the
/// ends of the shorter axis. The gap grows as the power 3/2 of the distance. out: 1 for a circle.
double edge_steepness(const contact::Ellipse& shape);

/// Width, in Hertz radii, of the zones at inlet and outlet in which the film forms: (Hm/edge_steepness)^(2/3), where Hm
/// is the expected minimum film, because the gap grows as the power 3/2 of the distance from the edge. in: M > 0, L >=
/// 0.
double film_zone(double M, double L, const contact::Ellipse& shape = {});

/// Mesh size along X, in Hertz radii, that resolves the film: 0.3 film_zone, and at most 0.4 of contact_size along the
/// shorter axis; 0.2 and 0.2 for the first-order wedge. For cells that are longer along X it is the mesh size along Y.
/// order: the error of the second-order wedge in Hm is about 0.4 (hx/film_zone)^2. in: M > 0, L >= 0.
double resolving_step(double M, double L, reynolds::Wedge wedge, const contact::Ellipse& shape = {});

/// Aspect ratio hy/hx of the cells. [bench: cell_aspect]
///   2 if the contact is more than seven times as wide as long in the rolling direction: it varies slowly along Y.
///   1/4, 1/8 or 1/16 if it is more than six times as long as wide: the smallest of these that is not below the
///   ratio of its axes. Scaled by its semi-axes such a contact is a circle, so that the strips at the sides, where
///   the film is thinnest, get as many cells as the ends.
///   1 for all others, and for every oblique contact, whose spike crosses the grid lines.
double cell_aspect(const contact::Ellipse& shape);
/// True if the contact is elongated in the rolling direction: more than six times as long as wide, in line with the
/// motion or oblique to it.
bool elongated(const contact::Ellipse& shape);

/// Cells along x: `fewest`, doubled until the mesh size on this length of domain is at most `step`, without exceeding
/// `most`.
int resolving_cells(double step, double length, int fewest, int most);

}  // namespace ehl::steady
