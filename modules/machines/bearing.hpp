#pragma once
// Contact of a ball or roller with its race: radii, speeds, and distribution of a radial load.
//   D    diameter of ball or roller         d_m  diameter of the circle of their centres (pitch diameter)
//   Z    their number                       f    groove conformity, radius of the groove over D
//   alpha  contact angle                    gamma = D cos(alpha)/d_m
// Assumptions: rigid rings, rolling without slip, no centrifugal forces; both races then have the same contact angle
// and load.
// contact angle and carry the same load.
#include <vector>

namespace ehl::machines {

enum class Race { inner, outer };

/// Lengths in m. in: 0 <= contact_angle < 90 degrees; diameter < pitch_diameter/cos(contact_angle), so that the inner
/// race has a positive radius.
struct Bearing {
  double diameter;
  double pitch_diameter;
  double contact_angle = 0.0;  ///< [degrees]
  Race race = Race::inner;
};

/// D cos(alpha)/d_m.
double gamma(const Bearing& bearing);

/// Radius of the race in the plane of rolling, at the contact: (d_m/cos(alpha) - D)/2 for the inner race, + for the
/// outer.
double race_radius(const Bearing& bearing);

/// R_x: 1/R_x = 2/D + 1/race_radius for the inner race (convex), - for the outer; hence R_x = D (1 -+ gamma)/2.
double radius_along(const Bearing& bearing);

/// R_y of a ball in a groove: 1/R_y = 2/D - 1/(f D), so R_y = D f/(2f - 1). in: D [m], f > 1/2.
double radius_across(double diameter, double conformity);

/// Revolutions per minute, all with one sense of rotation positive.
struct Turning {
  double inner;
  double outer;
  double cage;
};

/// The cage turns with the centres of the elements, which roll on both rings:
///   n_cage = [n_inner (1 - gamma) + n_outer (1 + gamma)]/2.
/// in: two of the three, the third NaN; gamma in (0, 1). out: all three.
/// source: rolling without slip; Harris and Kotzalas, Essential Concepts of Bearing Technology, chapter on speeds.
Turning complete(const Turning& two, double gamma);

/// Speed of both surfaces relative to the contact: (pi/60) |n_race - n_cage| d_m (1 -+ gamma), equal to (pi/120) d_m (1
/// - gamma^2) |n_inner - n_outer| at either race. out: [m/s].
double rolling_speed(const Bearing& bearing, const Turning& turning);

/// Exponent of load Q = K delta^n: 3/2 for point contacts (Hertz), 10/9 for line contacts (Palmgren).
inline constexpr double exponent_of_balls = 3.0 / 2.0, exponent_of_rollers = 10.0 / 9.0;

/// A radial load on a bearing with rigid rings, without clearance or preload.
struct RadialLoad {
  double load;           ///< F_r > 0 [N]
  int elements;          ///< Z >= 3, equally spaced
  double azimuth = 0.0;  ///< of the first element, from the direction of the load [degrees]
  double exponent = exponent_of_balls;
};

/// Static equilibrium. The ring moves by delta in the direction theta; an element at psi_j is compressed by
///   delta_j = delta cos(psi_j - theta)
/// and carries Q_j = K delta_j^n if delta_j > 0, else nothing:
///   sum Q_j cos(psi_j) = F_r,   sum Q_j sin(psi_j) = 0.
/// The second equation has one solution theta, because the potential of the forces is convex; the first gives K
/// delta^n.
/// out: Q_j [N] of all elements, the first at the azimuth. For many balls the largest is 4.370 F_r/Z, for many rollers
/// 4.08: Stribeck (1901), who uses 5 for a bearing with clearance.
std::vector<double> element_loads(const RadialLoad& load);

}  // namespace ehl::machines
