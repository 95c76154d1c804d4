#pragma once
// The scene of a steady contact as it is computed in time.
#include "steady/scene.hpp"
#include "transient/conditions.hpp"

namespace ehl::transient {

/// The same contact with the cycles that steps of time want, on half of the domain only where that stays so, and with a
/// supply without end where mass is conserved and none was given.
steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions);

}  // namespace ehl::transient
