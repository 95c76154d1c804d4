#pragma once
// A cam that turns at constant speed against a flat tappet: radius of curvature, speeds and load of their contact.
//   phi angle of the cam, s(phi) lift, ' = d/dphi, r_b base circle radius, omega speed of the shaft
// The normal of the contact is the direction of the lift, at the distance s' from the axis. In the frame of the contact
//   R = r_b + s + s"        cam: u1 = omega (r_b + s + s")       tappet: u2 = omega s"
// source: Dyson and Naylor 1960. The tappet does not rotate.
#include <optional>

#include "machines/spline.hpp"

namespace ehl::machines {

/// Lengths in m, angles in radians.
struct Cam {
  double base_radius;
  Spline lift;                    ///< over one revolution, or over a part of it outside of which the lift is 0
  std::optional<Spline> load{};   ///< [N], linear between the same angles; nullopt: spring and inertia give it
  double spring_force = 0.0;      ///< force of the spring at lift 0 [N]
  double spring_stiffness = 0.0;  ///< of the spring [N/m]
  double mass = 0.0;              ///< that moves with the tappet [kg]
};

/// State of the contact at one angle.
struct CamState {
  double lift;    ///< s
  double second;  ///< s"
  double R;       ///< r_b + s + s"; not positive where the flank is too concave for a flat tappet
  double u1;      ///< of the cam [m/s]
  double u2;      ///< of the tappet
  double load;  ///< spring_force + spring_stiffness s + mass omega^2 s", or that of the table; not positive: the tappet
                ///< lifts off
};
/// in: any angle; omega > 0 [rad/s].
CamState state_at(const Cam& cam, double phi, double omega);

/// An estimate of the error of s": a third of its largest change if every second point of the lift is left out. Large
/// if the table is too coarse or has too few digits. out: [m].
double error_of_second(const Cam& cam);

}  // namespace ehl::machines
