#pragma once
// The state at the start of a transient.
#include "fmg/hierarchy.hpp"
#include "transient/contact_dae.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// Relative residual of a state that is as good as steady: its film moves by less than 1e-9 in a long time.
inline constexpr double settled_residual = 1e-9;

/// Takes the finest level from the steady solution of the scene to the steady state of T = 0, with its load, speed and
/// surfaces: bit by bit, as exactly as rounding allows, the load exact.
/// in: start, the drive at T = 0.
/// errors: core::SolverError where that state is not found.
void settle(fmg::Hierarchy& hierarchy, ContactDae& dae, const Drive& start);

/// y and y' at T = 0: that steady state, or the bodies apart.
Checkpoint first_state(fmg::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions);

}  // namespace ehl::transient
