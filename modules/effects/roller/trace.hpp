#pragma once
// Measured roller profile: levelling, smoothing, and its roughness.
#include <vector>

#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Cut-off between form and roughness, in half widths a. Longer waves are accommodated by elastic deformation.
inline constexpr double longest_of_roughness = 2.5;

/// Levels and smooths the drops H(Y), in a and a^2/R, as profile.trace requires, and writes the subtracted slope and
/// the roughness before and after smoothing there.
/// in: Y increasing; mirrored: the points are half of a symmetric roller, from Y = 0 on; profile.length. cost:
/// gaussian_filter.hpp.
void condition(const std::vector<double>& Y, std::vector<double>& H, bool mirrored, Profile& profile);

}  // namespace ehl::roller
