#pragma once
// A roller cut into slices that know nothing of one another: what of it bears the load, before anything is solved.
#include "effects/roller/profile.hpp"

namespace ehl::roller {

struct Bearing {
  double length;    ///< of the slices that bear a load [a]
  double heaviest;  ///< load per length of the slice that carries most, over the mean
};

/// Every slice is pressed in by what the approach of the bodies leaves above its drop and tilt, and bears in
/// proportion: the mean load per length where that is the approach of a line contact so long as the roller.
Bearing bearing(const Profile& profile);

/// Approach of the bodies of a line contact without ends, length half widths long, in a^2/R: [1 + 2 ln(2 length)]/4,
/// the displacement in the middle below Hertz' half ellipse on a strip.
double approach_of_line(double length);

}  // namespace ehl::roller
