#pragma once
#include <limits>
#include <numbers>

namespace ehl::core {

inline constexpr double pi = std::numbers::pi;
/// A value that is not known, and is printed as such.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace ehl::core
