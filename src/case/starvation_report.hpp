#pragma once
// The numbers of a contact with a supply, for the report, the JSON, the result file and the tables.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// Starvation factor, supply, meniscus and oil flows, each with unit and meaning.
std::vector<results::Quantity> starvation_quantities(const Case& input, const steady::Solution& solution);
/// Columns for the passes over a track, with the published formulas.
std::vector<Column<steady::Pass>> pass_columns(const Case& input, const steady::Solution& solution);
/// The layer across the track after every pass: columns pass, y, layer.
results::Table table_of_tracks(const steady::Solution& solution);
/// The printed part of the summary.
std::string starvation_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
