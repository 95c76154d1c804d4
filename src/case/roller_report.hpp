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
std::vector<std::string> roller_warnings(const RollerResult& result);
std::string roller_summary(const Case& input, const Computed& computed);

}  // namespace ehl::program
