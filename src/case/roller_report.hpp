#pragma once
// The numbers of a roller, for the report, the JSON and the result file.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"
#include "core/warning.hpp"

namespace ehl::program {

/// The distribution along the roller as quantities and as a table: one row per slice.
std::vector<results::Quantity> roller_quantities(const Case& input, const RollerResult& result);
std::vector<Column<roller::Slice>> slice_columns();
/// Warnings about loaded ends, where the assumption of half-spaces fails. In a sweep, which computes no coarser grid,
/// these are the only warnings about a roller.
core::Warnings edge_warnings(const roller::Distribution& found);
/// All warnings about a roller, and its part of the summary.
core::Warnings roller_warnings(const RollerResult& result);
std::string roller_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
