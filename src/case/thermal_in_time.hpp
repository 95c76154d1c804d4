#pragma once
// Heat in a run in time.
#include "case/effects.hpp"
#include "case/numbers/number.hpp"

namespace ehl::program {

/// Refuses what a run in time with heat cannot do.
void check_thermal_in_time(Case& input);

/// What [thermal] adds to a run in time: the factors on the coefficients, temperatures and heat at every step, and the
/// temperature fields that the deck keeps.
InSteps thermal_in_steps(const Case& input);

/// The columns of /transient that a steady contact has no number for.
std::vector<numbers::Group> thermal_step_numbers();

/// The lines of the report about the run in time; empty without one.
std::string thermal_in_time_summary(const Case& input, const Computed& computed);

/// Adds the warnings about the run in time.
void thermal_in_time_warnings(const Case& input, const TransientResult& result, core::Warnings& list);

}  // namespace ehl::program
