#pragma once
// The dry impact of two bodies by Hertz' theory: their approach delta under the load F is c F^(2/3), and
//   m v^2/2 = (2/5) F delta at the turning point,  contact during 2 delta/v * integral of (1 - x^(5/2))^(-1/2) over
//   0..1.
// source: Hertz 1881; Johnson, Contact Mechanics, section 11.4. No waves, no plastic flow: v well below that of sound.

namespace ehl::machines {

struct DryImpact {
  double load;      ///< largest load [N]
  double approach;  ///< largest approach, delta [m]
  double duration;  ///< time of contact, 2.943 delta/v [s]
};

/// in: mass that meets a body at rest, or m1 m2/(m1 + m2) [kg]; velocity [m/s]; compliance, the approach under 1 N [m].
DryImpact dry_impact(double mass, double velocity, double compliance);

}  // namespace ehl::machines
