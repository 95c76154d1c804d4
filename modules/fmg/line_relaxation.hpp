#pragma once
// The relaxation of a line contact, its nodes side by side.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// True where relax_along_line() can do it: by elimination, and without an unknown content, whose rows are made one
/// after the other.
bool relaxes_along_line(const core::Patch& grid, const RelaxationParameters& parameters,
                        reynolds::Cavitation cavitation);

/// What line_batch.cpp does with many lines at once, with one: its rows are made along the line, some nodes in a
/// vector, and its changes applied likewise. The elimination alone goes from node to node, from both ends of the line
/// at once. in: work made for this reach.
template <int reach>
line_solvers::SmallPivot relax_along_line(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

}  // namespace ehl::fmg
