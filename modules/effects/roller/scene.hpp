#pragma once
// A roller as a scene of the steady solver, and the dry contact from which it starts.
#include "dry/solve.hpp"
#include "effects/roller/profile.hpp"
#include "steady/scene.hpp"

namespace ehl::roller {

/// Adds the profile to the surfaces of the scene and makes the scene start from the dry contact, because Hertz'
/// pressure along the whole length is far from the solution. [bench: roller_dry_start]
/// in: a scene with contact::roller_contact() and its grid.
void lay(const Profile& profile, steady::Scene& scene);

/// Dry contact of such a scene on a grid. The contact may extend to the ends.
dry::Problem dry_problem(const steady::Scene& scene, const core::Patch& grid);

}  // namespace ehl::roller
