#pragma once
// The numbers of a roller, for the report, JSON and the result file.
#include <string>
#include <vector>

#include "base/column.hpp"
#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

std::vector<results::Quantity> roller_quantities(const Case& input, const RollerResult& result);
std::vector<Column<roller::Slice>> slice_columns();
/// Of ends that bear, where half-spaces end too; in a sweep, which computes no coarser grid, the only one.
std::vector<std::string> edge_warnings(const roller::Distribution& found);
std::vector<std::string> roller_warnings(const RollerResult& result);
std::string roller_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
