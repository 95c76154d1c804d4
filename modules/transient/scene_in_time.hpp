#pragma once
// The steady scene, prepared for time integration.
#include "steady/scene.hpp"
#include "transient/conditions.hpp"

namespace ehl::transient {

/// A copy of the scene with V(2,1) cycles by default, on half of the domain only if the conditions stay symmetric, and
/// with an infinite supply if mass is conserved and the scene has none.
steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions);

/// Line contacts in the unit of length of scene_in_time(): how much its H00 exceeds the one for the unit a. 0 for
/// points.
double shift_of_unit(const steady::Scene& scene);

}  // namespace ehl::transient
