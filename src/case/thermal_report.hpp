#pragma once
// The numbers of a contact with heat, for the report, JSON, the result file and the tables.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// "W", or of a line contact "W/m".
const char* unit_of_heat(bool line);
std::vector<results::Quantity> thermal_quantities(const Case& input, const HeatResult& heat);
/// Of the sequence of grids, in kelvin.
std::vector<Column<heat::Row>> thermal_columns(const HeatInput& input);
/// What a user must know: temperatures beyond the laws, too few nodes across, surfaces at rest, lines at low speed.
std::vector<std::string> thermal_warnings(const Case& input, const HeatResult& heat);
std::string thermal_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
