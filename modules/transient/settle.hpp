#pragma once
// State at the start of a time integration.
#include "multigrid/hierarchy.hpp"
#include "transient/contact_dae.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// Puts the steady solution at T = 0 on the finest level, solved by itself, if conditions differ from those of the
/// scene and it is found. returns the drive of the state that the level then holds.
Drive begin_with(multigrid::Hierarchy& hierarchy, ContactDae& dae, const steady::Scene& scene,
                 const Conditions& conditions);

/// Takes the finest level from the steady state of one drive to that of T = 0, with its load, speed and surfaces: by
/// increments, to rounding, with exact load.
/// in: from, the drive of the state that the level holds; start, that at T = 0.
/// errors: core::SolverError if that state is not found.
void settle(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& from, const Drive& start);

/// y and y' at T = 0: the steady state, or a body at its gap. With an effect on the coefficients both are steady
/// together. in: from, the drive of the state that the level holds.
Checkpoint first_state(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions,
                       const Drive& from, const Coupling* coupling);

}  // namespace ehl::transient
