#pragma once
// What a run in time records of the state that its hierarchy holds.
#include "transient/contact_dae.hpp"
#include "transient/march.hpp"

namespace ehl::transient {

/// H at (0, 0).
double central_film(const multigrid::Level& level);

/// The row of a step that has just been accepted, without probes and measured numbers. H00 is that of the hierarchy.
StepRow row_of(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
               const StepReport& step);

/// The state at T, which the hierarchy holds.
Snapshot snapshot_of(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
                     double T, const core::Field& P, const core::Field& H);

}  // namespace ehl::transient
