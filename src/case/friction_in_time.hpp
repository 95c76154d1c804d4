#pragma once
// Friction at every step of a run in time, by the formulas of a steady contact.
#include "case/effects.hpp"
#include "case/numbers/number.hpp"

namespace ehl::program {

/// What [friction] adds to a run in time: coefficients over the load that the film carries, forces, power, and the
/// tractions that the deck keeps.
InSteps friction_in_steps(const Case& input);

/// The sliding friction over the load that the film carries, of a case without [friction].
std::function<double(const transient::Snapshot& state)> sliding_in_steps(const Case& input);

/// The columns of /transient that a steady contact has no number for.
std::vector<numbers::Group> friction_step_numbers();

/// The lines of the report about the course of the friction; empty without a run in time.
std::string friction_in_time_summary(const Case& input, const Computed& computed);

/// The warnings of friction::warnings() for the step at which they are most serious.
core::Warnings friction_in_time_warnings(const Case& input, const TransientResult& result);

}  // namespace ehl::program
