#pragma once
// A roller cut into slices that know nothing of one another: what of it bears the load, before anything is solved.
#include "effects/roller/profile.hpp"

namespace ehl::roller {

struct Bearing {
  double length;    ///< of the slices that bear a load [a]
  double heaviest;  ///< load per length of the slice that carries most, over the mean
};

/// Every slice is pressed in by what the approach of the bodies leaves above its drop and tilt, and bears in
/// proportion: the mean load per length where that is the approach of contact::roller_contact().
Bearing bearing(const Profile& profile);

}  // namespace ehl::roller
