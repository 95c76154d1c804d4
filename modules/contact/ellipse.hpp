#pragma once
// The elliptic Hertz contact and its orientation to the direction of entrainment.
#include "core/quadratic_form.hpp"

namespace ehl::contact {

/// Shape of a contact with the principal radii R_x, on which all groups and scales are based, and R_y. Lengths are in
/// a, the semi-axis of the Hertz ellipse along R_x; b is the one along R_y. Dry contact values are relative to the
/// circular contact with radius R_x and the same load and bodies. The default is that circle.
struct Ellipse {
  double radius_ratio = 1.0;  ///< R_x/R_y; 0: a line contact, see line_contact()
  double angle = 0.0;         ///< from the direction of R_x to that of the entrainment [degrees]
  double kappa = 1.0;         ///< b/a; infinite for a line contact, length/2 for a roller
  double a = 1.0;             ///< a over that of the circle
  double p_h = 1.0;           ///< maximum pressure over the circle's
  double approach = 1.0;      ///< mutual approach of the dry bodies, in a^2/R_x
  double length = 0.0;        ///< of a roller, in a; 0: not a roller
};

/// The exact Hertz ellipse. With the larger radius R_s, the smaller R_e, kappa the longer over the shorter semi-axis, m
/// = 1 - 1/kappa^2, K(m) and E(m) the complete elliptic integrals,
///   R_s/R_e = [kappa^2 E - K]/[K - E],   longer^3 = 6 F R_e (kappa^2 E - K)/(pi E' m),   p_h = 3 F/(2 pi a b).
/// in: R_x/R_y > 0; angle [degrees]. error of kappa: a few times rounding, also near 1. limits: R_x/R_y = 1 gives the
/// exact circle for any angle. source: Hertz (1881); Johnson, Contact Mechanics (1985), section 4.2.
Ellipse ellipse(double radius_ratio, double angle = 0.0);

/// True for a circular contact.
inline bool circular(const Ellipse& shape) { return shape.radius_ratio == 1.0; }

/// Contact of long parallel cylinders, R_y infinite. a is the half width, 8 F' R_x/(pi E') = a^2 with the load per
/// length F'; p_h = 2 F'/(pi a). The deformation is -(1/pi) integral of P ln|X - X'| dX'; with lengths in a in the
/// logarithm the approach is 1/4 + ln(2)/2. The ratio p_h to that of a circle is that of the elastic factors.
Ellipse line_contact();
/// True for a line contact.
inline bool line(const Ellipse& shape) { return shape.radius_ratio == 0.0; }

/// A finite part of a line contact, `length` long in a. Groups and scales are those of the line contact with the mean
/// load per length. The kernel is that of a half-space with the factor 2 p_h R_x/(pi E' a) = 1/(2 pi). The approach is
/// that at the middle under the same pressure everywhere: (1/2) ln(length) more than for the line, up to 1/length^2.
/// in: length > 2.
Ellipse roller_contact(double length);
/// True for a roller.
inline bool roller(const Ellipse& shape) { return shape.length > 0.0; }

/// Frame of the entrainment: X along it, lengths in a. With x along R_x and y along R_y
///   x = X cos(angle) - Y sin(angle),   y = X sin(angle) + Y cos(angle).
/// The undeformed gap is x^2/2 + (R_x/R_y) y^2/2, in a^2/R_x. XY is exactly 0 at 0 and 90 degrees.
core::QuadraticForm gap(const Ellipse& shape);
/// Outline of the dry contact: x^2 + y^2/kappa^2 = 1; for lines and rollers x^2 = 1.
core::QuadraticForm outline(const Ellipse& shape);

/// Half sides of the rectangle around the outline, along X and Y, and the shorter semi-axis.
struct Extent {
  double X;
  double Y;
  double shorter;
};
Extent extent(const Ellipse& shape);

/// Factor of K*P in the film equation, 2 p_h R_x/(pi E' a): 2/pi^2 for a circle, 1/(2 pi) for a roller, 1/pi for a
/// line, whose kernel is logarithmic.
double elastic_factor(const Ellipse& shape);
/// Load over that of a circle with the same a and p_h: kappa; for a line on the length a 3/4; for a roller on its whole
/// length.
double relative_load(const Ellipse& shape);
/// Load in units of p_h a^2: (2 pi/3) kappa; for a line (pi/2) p_h a per length; for a roller (pi/2) length.
double load(const Ellipse& shape);

/// M and L based on R_e, the radius along the entrainment, instead of R_x; R_s is the radius across it:
///   1/R_e = cos^2/R_x + sin^2/R_y,   1/R_s = sin^2/R_x + cos^2/R_y.
/// A film in Moes' units based on R_e, times `film`, is one based on R_x.
struct AlongEntrainment {
  double M;
  double L;
  double radius_ratio;  ///< R_e/R_s
  double film;
};
AlongEntrainment along_entrainment(const Ellipse& shape, double M, double L);

}  // namespace ehl::contact
