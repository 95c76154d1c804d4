#pragma once
// Friction of a scene of the steady solver, with the oil outside its domain.
#include "effects/friction/friction.hpp"
#include "steady/scene.hpp"

namespace ehl::friction {

/// True if the far field continues outside the domain, and the gap is full of oil there.
bool oil_outside(const steady::Scene& scene);

/// Friction of a solution of the scene on one grid. Where no oil lies outside of a flooded domain, the rolling friction
/// of the outer half of the inlet is reported separately.
Friction friction_of(const steady::Scene& scene, const steady::SolvedFilm& film, Parameters parameters);

}  // namespace ehl::friction
