#pragma once
// Slice model of a roller: independent slices give an estimate of the load distribution before anything is solved.
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Load distribution of a roller by the slice model.
struct Bearing {
  double length;    ///< of the slices that carry load [a]
  double heaviest;  ///< load per length of the most heavily loaded slice, over the mean
  double at_ends;   ///< the same at the more heavily loaded end
  double widest;    ///< estimated half width of the most heavily loaded slice [a]
};

/// Every slice is compressed by the approach of the bodies minus its drop and tilt, and its load is proportional to
/// that compression. The proportionality constant gives the mean load per length at the approach of
/// contact::roller_contact(). Half width: heaviest^0.65. [bench: roller_slice_width]
Bearing bearing(const Profile& profile);

}  // namespace ehl::roller
