#pragma once
// Film and coefficients of a line contact.
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// True if the nodes of a line contact are processed as one contiguous array; false in the linear model problems.
bool along_one_line(const Hierarchy& hierarchy, const Level& level);

/// update_coefficients() of a line contact, all nodes at once, with the same bits as column by column (constant X): a
/// column of a line contact has one node and would leave the vector registers empty.
void coefficients_along_line(Hierarchy& hierarchy, Level& level);
/// update_film() of a line contact.
void film_along_line(Hierarchy& hierarchy, Level& level);

}  // namespace ehl::multigrid
