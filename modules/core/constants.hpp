#pragma once
#include <numbers>

namespace ehl::core {

inline constexpr double pi = std::numbers::pi;

}  // namespace ehl::core
