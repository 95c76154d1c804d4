#pragma once
// The numbers of a solved case, each with name, unit and meaning, for the JSON report and the result file.
#include "base/column.hpp"
#include "report/outcome.hpp"

namespace ehl::program {

using results::Quantity;

/// Film, pressure and their errors.
std::vector<Quantity> film_quantities(const Case& input, const steady::Solution& solution, const Outcome& outcome);
/// The checks of the final state.
std::vector<Quantity> verification_quantities(const steady::Verification& checked, const contact::Ellipse& shape);
/// The groups of the contact; its scales in SI if they are known; the numbers of the bearing or the gears.
std::vector<Quantity> scale_quantities(const Case& input);
/// The numbers of the bearing or the gears alone, "bearing_gamma"; in a JSON report they are members of "bearing".
std::vector<Quantity> machine_quantities(const machines::Contact& machine);

/// The columns of the tables of levels, cycles and load continuation.
std::vector<Column<steady::LevelRow>> level_columns();
std::vector<Column<steady::CycleRow>> cycle_columns();
std::vector<Column<steady::ContinuationStep>> continuation_columns();

}  // namespace ehl::program
