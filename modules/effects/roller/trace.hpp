#pragma once
// A profile as an instrument traced it: levelled and smoothed as the deck says, and how rough it is.
#include <vector>

#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Cut-off between form and roughness, in half widths a. Bodies follow longer waves by their elastic deformation.
inline constexpr double longest_of_roughness = 2.5;

/// Levels and smooths the drops H at Y [a, a^2/R], as profile.trace says, and enters there what was found: the slope
/// that was taken away, and the roughness before and after smoothing.
/// in: Y growing; mirrored: they are one half of the roller, from Y = 0 on; profile.length. cost: gaussian_filter.hpp.
void condition(const std::vector<double>& Y, std::vector<double>& H, bool mirrored, Profile& profile);

}  // namespace ehl::roller
