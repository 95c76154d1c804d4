#pragma once
// State at the start of a time integration.
#include "multigrid/hierarchy.hpp"
#include "transient/contact_dae.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// Takes the finest level from the steady solution of the scene to the steady state at T = 0, with its load, speed and
/// surfaces: by increments, to rounding, with exact load.
/// in: start, the drive at T = 0.
/// errors: core::SolverError if that state is not found.
void settle(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& start);

/// y and y' at T = 0: the steady state, or a body at its gap.
/// With an effect on the coefficients both are steady together.
Checkpoint first_state(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions,
                       const Coupling* coupling);

}  // namespace ehl::transient
