#pragma once
// Mesh of two external involute spur gears along the path of contact.
//   m module, z1 and z2 teeth, alpha pressure angle, x1 and x2 profile shift, h_a addendum factor; wheel 1 drives
// A point on the path is given by its distance s from T1, where the line of action touches the base circle of wheel 1;
// at T2 it touches that of wheel 2. Contact begins at A, at the tip of wheel 2, and ends at E, at the tip of wheel 1.
// Between B and D one pair of teeth carries the load alone if the contact ratio is below 2; C is the pitch point.
// source: ISO 21771. No backlash; tips are shortened with profile shift so that their clearance is constant.

namespace ehl::machines {

/// Data of a gear pair, as listed above.
struct Gears {
  double module;  ///< [m]
  int teeth1;
  int teeth2;
  double pressure_angle = 20.0;  ///< [degrees]
  double shift1 = 0.0;
  double shift2 = 0.0;
  double addendum = 1.0;
};

/// Lengths in m.
struct PathOfContact {
  double working_angle;    ///< [degrees], inv(alpha_w) = inv(alpha) + 2 tan(alpha) (x1 + x2)/(z1 + z2)
  double centre_distance;  ///< m (z1 + z2)/2 cos(alpha)/cos(alpha_w)
  double base_radius1;     ///< m z1 cos(alpha)/2
  double base_radius2;
  double tip_alteration;  ///< k = a_w/m - (z1 + z2)/2 - (x1 + x2) <= 0, a_w the centre distance
  double tip_radius1;     ///< m (z1/2 + h_a + x1 + k)
  double tip_radius2;
  double tip_thickness1;  ///< of a tooth, 2 tip_radius [(pi/2 + 2 x tan(alpha))/z + inv(alpha) - inv(alpha_a)],
  double tip_thickness2;  ///< cos(alpha_a) = base_radius/tip_radius; negative: the flanks meet below the tip circle
  double base_pitch;      ///< pi m cos(alpha)
  double length_T1T2;     ///< centre_distance sin(alpha_w)
  double A, B, C, D, E;   ///< distances from T1
  double contact_ratio;   ///< (E - A)/base_pitch
};

/// in: m > 0, teeth >= 3, 0 < pressure_angle < 90. out: NaN if no such mesh exists: profile shifts that need a negative
/// working angle, or tips inside their base circle. A < 0 or E > length_T1T2 means interference: a tip touches the
/// other wheel below its base circle.
PathOfContact path_of_contact(const Gears& gears);

/// Load sharing between two pairs of teeth.
///   none    every pair carries the full load at all positions
///   linear  equal stiffness, no tip relief: from 1/3 at A to 2/3 at B, 1 between B and D, from 2/3 at D to 1/3 at E
///           (AGMA 925-A03; ISO/TS 6336-20). The shares of two pairs add up to 1.
enum class Sharing { none, linear };

/// in: s between A and E; contact ratio from 1 to 2. out: share of the load of the pair in contact at s.
double share(const PathOfContact& path, double s, Sharing sharing);

/// Radii of curvature and speeds of both teeth at their contact.
struct Mesh {
  double rho1;  ///< radius of curvature, s [m]
  double rho2;  ///< length_T1T2 - s
  double R;     ///< rho1 rho2/(rho1 + rho2)
  double u1;    ///< surface speed relative to the contact, omega1 rho1 [m/s]
  double u2;    ///< omega2 rho2, omega2 = omega1 z1/z2
};
/// in: omega1 > 0 [rad/s].
Mesh mesh_at(const Gears& gears, const PathOfContact& path, double s, double omega1);

}  // namespace ehl::machines
