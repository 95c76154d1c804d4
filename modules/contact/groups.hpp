#pragma once
// Dimensionless groups of a contact, and the conventions on which they are based.
//
// CONVENTIONS. All other places refer to these and do not restate them.
//   E'  = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2]       reduced modulus (contact/hertz.hpp)
//   u_s = u1 + u2, u_m = u_s/2                      sum and mean of the surface speeds; entrainment is along +x
//   R   = R_x                                       radius of the equivalent ball on a plane; of an elliptic contact
//                                                   the principal radius along the entrainment, or at an angle to it
//   X = x/a, Y = y/a, P = p/p_h, H = h R/a^2        a, p_h of Hertz, a the semi-axis in the direction of R_x; the
//                                                   inlet is at negative X
//
//   Hamrock and Dowson   W = F/(E' R^2)   U = eta0 u_m/(E' R)   G = alpha E'
//   Moes                 M = W (2U)^(-3/4)          L = G (2U)^(1/4)
//   Venner               lambda = 6 eta0 u_s R^2/(a^3 p_h) = (128 pi^3/(3 M^4))^(1/3)
//                        alpha_bar = alpha p_h = (L/pi)(3M/2)^(1/3)
//   Line, F' the load per length: W = F'/(E' R), M = W (2U)^(-1/2), L as above; a = R (8W/pi)^(1/2), p_h = E' a/(4R),
//                        lambda = 3 pi^2/(8 M^2), alpha_bar = L (M/(2 pi))^(1/2)
// Both of Venner's are for a circle: for an ellipse lambda is divided by (a/a_c)^3 (p_h/p_c), alpha_bar multiplied by
// p_h/p_c, with a_c and p_c of the circle (contact/ellipse.hpp). With Barus' viscosity, M and L determine lambda and
// alpha_bar and thus the dimensionless solution; an elliptic contact also needs its ratio of radii and angle. W, U and
// G follow if one of them is known as well.
#include "contact/ellipse.hpp"
#include "core/constants.hpp"

namespace ehl::contact {

/// All groups of one contact. W, U, G are NaN if only M and L are known.
struct Groups {
  double M;
  double L;
  double lambda;
  double alpha_bar;
  double W = core::unknown;
  double U = core::unknown;
  double G = core::unknown;
  Ellipse shape{};
};

/// in: M > 0, L >= 0. out: lambda, alpha_bar; W, U, G = NaN.
Groups from_moes(double M, double L, const Ellipse& shape = {});
/// in: as above and U > 0. out: all groups.
Groups from_moes(double M, double L, double U, const Ellipse& shape = {});
/// Groups for film formulas: with a typical U if only M and L are known. In Moes' units the formulas depend on U only
/// weakly, h_c ~ U^-0.013 and h_m ~ U^0.003.
Groups with_typical_U(const Groups& groups);
/// in: W > 0, U > 0, G >= 0.
Groups from_hamrock_dowson(double W, double U, double G, const Ellipse& shape = {});

/// A contact in SI units.
struct SiContact {
  double load;     ///< F [N] > 0; for a line contact per length [N/m]
  double radius;   ///< R_x [m] > 0
  double E_prime;  ///< [Pa] > 0
  double u_s;      ///< u1 + u2 [m/s] > 0
  double eta0;     ///< viscosity at ambient pressure [Pa s] > 0
  double alpha;    ///< pressure-viscosity coefficient [1/Pa] >= 0
  Ellipse shape{};
};
/// out: all groups.
Groups from_si(const SiContact& contact);
/// The contact with given groups and radius R_x: inverse of from_si().
/// in: groups with W, U, G; radius [m], E_prime [Pa], eta0 [Pa s], all > 0.
SiContact to_si(const Groups& groups, double radius, double E_prime, double eta0);

/// p_h = alpha_bar/alpha [Pa]: Hertz pressure for M, L and a lubricant. in: alpha [1/Pa] > 0.
double hertz_pressure(const Groups& groups, double alpha);

/// a/R from W (Hertz).
double relative_half_width(double W, const Ellipse& shape);

/// H = h R/a^2 from Moes' H_M = (h/R)(2U)^(-1/2): H = H_M (3M/2)^(-2/3) (a_c/a)^2; for a line contact H_M pi/(8M).
double H_from_moes_units(double H_moes, double M, const Ellipse& shape = {});
/// H_M = H (3M/2)^(2/3) (a/a_c)^2.
double H_to_moes_units(double H, double M, const Ellipse& shape = {});
/// H = (h/R)(3W/2)^(-2/3) (a_c/a)^2.
double H_from_thickness_over_radius(double h_over_R, double W, const Ellipse& shape = {});

}  // namespace ehl::contact
