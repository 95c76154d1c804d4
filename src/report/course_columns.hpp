#pragma once
// The columns of the course of a solution: grid by grid, cycle by cycle, load by load.
#include "base/column.hpp"
#include "steady/solution.hpp"

namespace ehl::program {

std::vector<Column<steady::LevelRow>> level_columns();
std::vector<Column<steady::CycleRow>> cycle_columns();
std::vector<Column<steady::ContinuationStep>> continuation_columns();

}  // namespace ehl::program
