#pragma once
// The starts of a solution.
#include <vector>

#include "steady/cycle_choice.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {

/// Starts of the full multigrid from the Hertz pressure, in the order in which they are tried (starts.cpp).
std::vector<Start> starts_of(const Scene& scene);

/// The start for Newton's method.
const Start& usual_start();
/// The start for strategies that do not begin with cycles from the Hertz pressure at full load.
const Start& safe_start();

}  // namespace ehl::steady
