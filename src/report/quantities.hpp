#pragma once
// The numbers of a solved case, each with its name, unit and meaning: what the report as JSON and the result file say.
#include "base/column.hpp"
#include "report/outcome.hpp"

namespace ehl::program {

using results::Quantity;

/// Film, pressure and how well they are known.
std::vector<Quantity> film_quantities(const Case& input, const steady::Solution& solution, const Outcome& outcome);
/// The checks of the final state, beside one another.
std::vector<Quantity> verification_quantities(const steady::Verification& checked, const contact::Ellipse& shape);
/// The groups of the contact and, where they are known, its scales in SI; the numbers of the bearing or the gears.
std::vector<Quantity> scale_quantities(const Case& input);
/// Those last, "bearing_gamma", in a report as JSON members of "bearing".
std::vector<Quantity> machine_quantities(const machines::Contact& machine);

std::vector<Column<steady::LevelRow>> level_columns();
std::vector<Column<steady::CycleRow>> cycle_columns();
std::vector<Column<steady::ContinuationStep>> continuation_columns();

}  // namespace ehl::program
