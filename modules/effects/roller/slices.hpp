#pragma once
// A roller cut into slices that know nothing of one another: what of it bears the load, before anything is solved.
#include "effects/roller/profile.hpp"

namespace ehl::roller {

struct Bearing {
  double length;    ///< of the slices that bear a load [a]
  double heaviest;  ///< load per length of the slice that carries most, over the mean
  double at_ends;   ///< the same of the end that carries more
  double widest;    ///< half width of the contact where it carries most [a], about
};

/// Every slice is pressed in by what the approach of the bodies leaves above its drop and tilt, and bears in
/// proportion: the mean load per length where that is the approach of contact::roller_contact(). Their half widths
/// sqrt(heaviest) are 0.82 to 0.93 of those of Hertz' ellipses of crowns, 20 to 160 a long, which bear to a quarter and
/// more of it; sqrt(heaviest)^1.3 is 0.98 to 1.11 of them.
Bearing bearing(const Profile& profile);

}  // namespace ehl::roller
