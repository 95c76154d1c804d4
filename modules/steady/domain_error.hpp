#pragma once
// The error of the film that the finite domain causes, and the choice of the domain.
#include <optional>

#include "steady/scene.hpp"

namespace ehl::steady {

/// Rough estimate of the relative change of Hc if the domain grows without end: the sum of two effects.
///   Inlet: the pressure (4/3) lambda/|X_a|^3 that would build up upstream of X_a and is missing there (rigid far field
///   dP/dX = lambda/H^2, H = X^2/2). The relative change of the film is half of it times alpha_bar, with alpha_bar >=
///   10. For a line contact it is 8/11 of alpha_bar times the pressure (Grubin), with H the gap of the dry contact.
///   Load: the share of 2 pi/3 that the far field of a rigid body, P = -(lambda/5) X/H^2, would carry outside the
///   domain, times q, the power of the load with which the film falls: 2 for a rigid isoviscous contact, less if the
///   film is thicker than that (q = 2 H_RI/H, formulas of contact/film_formulas.hpp).
/// For an ellipse, whose undeformed gap is A X^2 + B Y^2 along the axes of the domain, the pressures are (1/3)
/// lambda/(A^2 |X_a|^3) and P = -lambda X/((3 + 2 B/A) H^2).
/// With the far field in closed form (scene.far_field): the error that remains, by closed_reach() below.
/// limits: right within a factor of about 2 if the viscosity rises with pressure, or for the load part at small M.
double rough_domain_error(const Scene& scene);

/// With the far field in closed form: how far upstream the domain must reach, in Hertz radii, for this error of Hc. It
/// is the larger of two distances. [bench: closed_reach]
///   Deformation, which the closed form treats as that of a point load: the error is lambda/(Hc |X_a|^5). For an
///   ellipse along X only the load outside counts, 5/(3 + 2 B/A) sqrt(A/B) of a circle's, with the rigid far field and
///   A and B as above. For an oblique ellipse the domain reaches to where the gap is as wide as at that distance across
///   its longer axis.
///   Rupture, whose lines are straight where the film is negligible against the gap: it falls with the fifth power too.
/// in: 0 < error.
double closed_reach(const Tuning& tuning, const ContactScales& scales, double error);

/// Default inlet boundary: the shortest that keeps the inlet part of rough_domain_error() below 0.6 % (line contacts
/// and rollers: 0.3 %) and the load part below 2 %, on a domain of the default width; with the far field in closed
/// form, closed_reach() for the given error.
/// The candidates keep (0,0) a node of every grid with a multiple of 32 cells: |X_a|/X_b = m/(32 - m), m = 20 .. 31,
/// with 64 and 128 cells for longer domains, up to |X_a| = 200. For an ellipse these are multiples of its extent along
/// X. At M = 50, L = 10 the result is the paper's -4.5. in: X_b > 0 the outlet boundary. out: X_a < 0.
double chosen_inlet(const Tuning& tuning, const ContactScales& scales, double X_b,
                    std::optional<double> far_field_error = {});

/// Default outlet boundary: 1.5, or 3 for a thick film (Hc > 1.5), which cavitates further downstream; for a thick film
/// with the far field in closed form, half of closed_reach(). For an ellipse 1.5 and 3 are multiples of its extent
/// along X; a line contact has 1.5 of its size.
double chosen_outlet(const Tuning& tuning, const ContactScales& scales, std::optional<double> far_field_error = {});

/// Default half width of the domain: half the length for a circle. For an ellipse the undeformed gap at the sides is as
/// wide as half a length away along X; at least 1.4 times the extent of the ellipse, and a multiple of 1/32 of the
/// length, so that hx = hy. With the far field in closed form it is a quarter wider, because the thinnest film lies at
/// the sides. [bench: wider_closed_domain]
/// Stretched cells: not widened, and a multiple of 1/128 of the length. in: X_a < X_b.
double chosen_half_width(const Tuning& tuning, double X_a, double X_b, const contact::Ellipse& shape = {},
                         bool far_field_closed = false);

/// Relative growth of Hc on a domain twice as long (upstream) and twice as wide, from two solutions on coarse grids of
/// the same mesh size. For lightly loaded contacts, where the load of the far field dominates: half of the rough
/// estimate.
/// It is a lower bound of the error of the domain; for lightly loaded contacts the region beyond the double domain adds
/// as much again. accuracy: within a factor of 2 if the error is about a percent. out: rough_domain_error() if one of
/// the two coarse solutions fails. cost: two solutions on coarse grids.
double estimate_domain_error(const Scene& scene);

}  // namespace ehl::steady
