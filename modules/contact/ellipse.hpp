#pragma once
// The dry elliptic contact of Hertz, and how it lies to the entrainment.
#include "core/quadratic_form.hpp"

namespace ehl::contact {

/// The shape of a contact of two principal radii: R_x, the one that all groups and scales are made with, and R_y.
/// Lengths are given in a, the semi-axis of the Hertz ellipse in the direction of R_x; b is the one in the direction of
/// R_y. What it says of the dry contact is relative to the circular one of the radius R_x, the same load and bodies.
/// Without anything said it is that circle.
struct Ellipse {
  double radius_ratio = 1.0;  ///< R_x/R_y; 0: a line contact, line_contact()
  double angle = 0.0;         ///< from the direction of R_x to that of the entrainment [degrees]
  double kappa = 1.0;         ///< b/a; infinite for a line, length/2 for a roller
  double a = 1.0;             ///< a over the circle's radius
  double p_h = 1.0;           ///< maximum pressure over the circle's
  double approach = 1.0;      ///< mutual approach of the dry bodies, in a^2/R_x
  double length = 0.0;        ///< of a roller, in a; 0: no roller
};

/// The exact ellipse of Hertz: with the larger radius R_s over the smaller R_e, m = 1 - 1/kappa^2 of the longer
/// semi-axis over the shorter, K(m) and E(m) the complete elliptic integrals,
///   R_s/R_e = [kappa^2 E - K]/[K - E],   longer^3 = 6 F R_e (kappa^2 E - K)/(pi E' m),   p_h = 3 F/(2 pi a b).
/// in: R_x/R_y > 0; angle [degrees]. out: kappa to a few times the rounding error, also where it is near 1.
/// limits: R_x/R_y = 1 is the circle exactly, whatever the angle. source: Hertz (1881); Johnson, Contact Mechanics
/// (1985), section 4.2.
Ellipse ellipse(double radius_ratio, double angle = 0.0);

inline bool circular(const Ellipse& shape) { return shape.radius_ratio == 1.0; }

/// The contact of long parallel cylinders, R_y without end. Its a is the half width, 8 F' R_x/(pi E') = a^2 with the
/// load per length F', p_h = 2 F'/(pi a), and the deformation -(1/pi) integral of P ln|X - X'| dX': the approach,
/// 1/4 + ln(2)/2, is that of the logarithm of lengths in a. The ratios to a circle are those of the elastic factors.
Ellipse line_contact();
inline bool line(const Ellipse& shape) { return shape.radius_ratio == 0.0; }

/// A piece of a line contact, `length` long in a: groups and scales are those of the line with the mean load per
/// length. Its kernel is that of a half-space, with the factor 2 p_h R_x/(pi E' a) = 1/(2 pi); the approach is that of
/// its middle under the same pressure everywhere, (1/2) ln(length) more than the line's, to 1/length^2. in: length > 2.
Ellipse roller_contact(double length);
inline bool roller(const Ellipse& shape) { return shape.length > 0.0; }

/// In the frame of the entrainment, X along it, lengths in a. With x along R_x and y along R_y
///   x = X cos(angle) - Y sin(angle),   y = X sin(angle) + Y cos(angle).
/// The undeformed gap x^2/2 + (R_x/R_y) y^2/2, in a^2/R_x. XY is exactly 0 at 0 and 90 degrees.
core::QuadraticForm gap(const Ellipse& shape);
/// The outline of the dry contact: x^2 + y^2/kappa^2 = 1; of a line and a roller x^2 = 1.
core::QuadraticForm outline(const Ellipse& shape);

/// Half the sides of the rectangle around an outline, along X and Y; and the shorter semi-axis.
struct Extent {
  double X;
  double Y;
  double shorter;
};
Extent extent(const Ellipse& shape);

/// The factor of K*P in the film equation, 2 p_h R_x/(pi E' a): 2/pi^2 for a circle, 1/(2 pi) for a roller; 1/pi for a
/// line, whose kernel is the logarithm.
double elastic_factor(const Ellipse& shape);
/// The load over that of a circle with the same a and p_h: kappa. Of a line on a length a, 3/4; of a roller on all of
/// it.
double relative_load(const Ellipse& shape);
/// The load in units of p_h a^2: (2 pi/3) kappa. Of a line pi/2 p_h a, per length; of a roller (pi/2) length.
double load(const Ellipse& shape);

/// M and L as they are with R_e, the radius along the entrainment, instead of R_x, and the ratio of that to R_s, the
/// radius across: 1/R_e = cos^2/R_x + sin^2/R_y, 1/R_s = sin^2/R_x + cos^2/R_y. A film in Moes' units with R_e times
/// `film` is one with R_x.
struct AlongEntrainment {
  double M;
  double L;
  double radius_ratio;  ///< R_e/R_s
  double film;
};
AlongEntrainment along_entrainment(const Ellipse& shape, double M, double L);

}  // namespace ehl::contact
