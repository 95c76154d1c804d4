#pragma once
// What the report and the numbers of a contact with heat are made of.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"
#include "thermal/inlet_heating.hpp"

namespace ehl::program {

/// The groups of the formulas for heating in the inlet.
thermal::InletGroups inlet_groups(const Case& input);
/// Hc over that of the isothermal contact.
double film_reduction(const HeatResult& heat);
/// Columns for the sequence of grids, with temperatures in kelvin.
std::vector<Column<heat::Row>> thermal_columns(const HeatInput& input);
/// Warnings: temperatures outside the range of the laws, too few nodes across the film, surfaces at
/// rest, low Peclet numbers.
core::Warnings thermal_warnings(const Case& input, const HeatResult& heat);
/// The printed part of the summary.
std::string thermal_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
