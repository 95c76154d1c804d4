#pragma once
#include <limits>
#include <numbers>

namespace ehl::core {

inline constexpr double pi = std::numbers::pi;
/// Not known, and told as such.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace ehl::core
