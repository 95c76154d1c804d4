#pragma once
// A roller as a scene of the steady solver, and the dry contact that it begins from.
#include "dry/solve.hpp"
#include "effects/roller/profile.hpp"
#include "steady/scene.hpp"

namespace ehl::roller {

/// Adds the profile to what the scene's surfaces carry, and lets the scene begin from the dry contact: Hertz' pressure
/// on all of the length is far from it. in: a scene with contact::roller_contact() and its grid.
void lay(const Profile& profile, steady::Scene& scene);

/// Such a scene without oil, on this grid. Its contact may reach the ends.
dry::Problem dry_problem(const steady::Scene& scene, const core::Patch& grid);

}  // namespace ehl::roller
