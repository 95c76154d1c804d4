#pragma once
// The relaxation of a line contact, whose nodes are stored as contiguous arrays.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// True if relax_along_line() applies: a line contact, the elimination as line solver, and not the mass-conserving
/// cavitation model, whose rows depend on the row before.
bool relaxes_along_line(const core::Patch& grid, const RelaxationParameters& parameters,
                        reynolds::Cavitation cavitation);

/// The relaxation of line_batch.cpp for a single line: the rows are assembled along the line, several nodes to a
/// vector, and the changes are applied in the same manner. Only the elimination goes from node to node, from both ends
/// of the line at once. in: work space made for this reach.
template <int reach>
line_solvers::SmallPivot relax_along_line(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

}  // namespace ehl::multigrid
