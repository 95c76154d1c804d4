#pragma once
// What the report and the numbers of a contact with a supply are made of.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// The starvation factor by formulas: of the supply (Chevalier 1998), of the meniscus (Hamrock, Dowson 1977; NaN: no
/// circle).
double factor_by_supply(const Case& input, const steady::Starvation& found);
double factor_by_meniscus(const Case& input, const steady::Starvation& found);
/// Columns for the passes over a track, with the published formulas.
std::vector<Column<steady::Pass>> pass_columns(const Case& input, const steady::Solution& solution);
/// The layer across the track after every pass: columns pass, y, layer.
results::Table table_of_tracks(const steady::Solution& solution);
/// The printed part of the summary.
std::string starvation_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
