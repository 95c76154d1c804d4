#pragma once
// The numbers of a contact with heat, for the report, the JSON, the result file and the tables.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// The unit of heat flow: "W"; "W/m" for a line contact.
const char* unit_of_heat(bool line);
/// Friction, temperatures and heat flows, each with unit, meaning and error.
std::vector<results::Quantity> thermal_quantities(const Case& input, const HeatResult& heat);
/// Columns for the sequence of grids, with temperatures in kelvin.
std::vector<Column<heat::Row>> thermal_columns(const HeatInput& input);
/// Warnings: temperatures outside the range of the laws, too few nodes across the film, surfaces at
/// rest, low Peclet numbers.
core::Warnings thermal_warnings(const Case& input, const HeatResult& heat);
/// The printed part of the summary.
std::string thermal_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
