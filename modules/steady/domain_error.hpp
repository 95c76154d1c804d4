#pragma once
// How much the film would grow if the domain did not cut off the inlet.
#include <optional>

#include "steady/scene.hpp"

namespace ehl::steady {

/// Roughly by how much, relative, Hc changes when the domain grows without end; the sum of two effects.
///   Inlet: the pressure that builds up before X_a and is missing there, (4/3) lambda/|X_a|^3 (the rigid far field
///   dP/dX = lambda/H^2, H = X^2/2); half of it times alpha_bar, alpha_bar >= 10, is the change of the film. Right
///   within a factor of about 2 where viscosity rises with pressure. Of a line contact 8/11 of it (Grubin), H the gap
///   of the dry contact: within a factor of 1.5 at (20, 5) to (200, 15).
///   Load: what the far field of a rigid body, P = -(lambda/5) X/H^2, would carry outside the domain, as a share of
///   2 pi/3, times q, the power of the load with which the film falls: 2 for a rigid isoviscous contact, less as the
///   film is thicker than that (q = 2 H_RI/H, formulas of contact/film_formulas.hpp). Within a factor of 2 of our own
///   solutions for M = 2 to 10 on inlets from 20 to 160.
/// Of an ellipse the undeformed gap is A X^2 + B Y^2 along the axes of the domain: (1/3) lambda/(A^2 |X_a|^3) and
///   P = -lambda X/((3 + 2 B/A) H^2).
/// With the far field in closed form (scene.far_field) what is left of it: closed_reach below.
double rough_domain_error(const Scene& scene);

/// With the far field in closed form: how far upstream the domain has to reach for an error of Hc of this size, in
/// Hertz radii. Of the deformation, which the closed form has as that of a point load: lambda/(Hc |X_a|^5), measured
/// within a factor of 2 at (20, 10), (100, 10), (1000, 10). An ellipse along X has less: of the rigid far field above,
/// with A and B, what lies outside carries 5/(3 + 2 B/A) sqrt(A/B) of a circle's; 2 to 10 times too much for R_x/R_y =
/// 3 to 20. Of rupture, whose lines are straight where the film itself is nothing beside the gap: 0.12 % at four times
/// sqrt(2 Hc) at (2, 0), with the fifth power too.
/// Of an ellipse aslant: to where the gap is as wide as that far from the middle across its longer axis.
/// in: M > 0, L >= 0, 0 < error.
double closed_reach(double M, double L, const contact::Ellipse& shape, double error);

/// Of Hc, on a domain that is chosen with the far field in closed form: on half of it less than 0.2 %.
inline constexpr double error_of_closed_domain = 5e-5;

/// The inlet boundary that a deck without one gets: the shortest that keeps the first part of rough_domain_error below
/// 0.6 % (of a line contact or roller 0.3 %) and the second below 2 %, on a domain half as wide as long, from a ladder
/// on which (0,0) is a node of every grid with a multiple of 32 cells, |X_a|/X_b = m/(32 - m), m = 20 .. 31, and of 64
/// and 128 cells for longer ones; no longer than 200. At M = 50, L = 10 that is the paper's -4.5. in: M > 0, L >= 0,
/// X_b > 0 the outlet boundary. out: X_a < 0. Of an ellipse these are multiples of how far it reaches along X. With the
/// far field in closed form: closed_reach for the error given.
double chosen_inlet(double M, double L, double X_b, const contact::Ellipse& shape = {},
                    std::optional<double> far_field_error = {});

/// The outlet boundary that a deck without one gets: 1.5, and 3 where the film is so thick (Hc > 1.5) that the
/// lubricant cavitates further downstream; with the far field in closed form half of closed_reach there.
/// in: M > 0, L >= 0.
double chosen_outlet(double M, double L, const contact::Ellipse& shape = {},
                     std::optional<double> far_field_error = {});

/// Half the width that a deck without one gets: half the length for a circle; else where the undeformed gap is as wide
/// at the sides as half a length away along X, at least 1.4 times as far as the ellipse reaches, and a multiple of a
/// 32nd of the length, so that hx = hy. With the far field in closed form a quarter wider, as the thinnest film lies at
/// the sides: halved, the width moves it by 0.1 % at M = 5 to 1000, where it was 0.2 to 1 % without. Where cells are
/// stretched no wider, and a multiple of a 128th. in: X_a < X_b.
double chosen_half_width(double X_a, double X_b, const contact::Ellipse& shape = {}, bool far_field_closed = false);

/// Relative growth of Hc on a domain twice as long (upstream) and twice as wide: two solutions on coarse grids of the
/// same mesh size; for light loads, where the load of the far field governs it, half of the rough estimate. It is a
/// lower bound of the error of the domain; in light loads what lies beyond the double domain adds as much again.
/// order: right within a factor of 2 where it is a percent (the meshes are coarse). out: rough_domain_error where one
/// of the two coarse solutions fails. cost: a few hundredths of a second.
double estimate_domain_error(const Scene& scene);

}  // namespace ehl::steady
