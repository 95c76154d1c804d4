#pragma once
// Film and coefficients of a line contact.
#include "fmg/hierarchy.hpp"

namespace ehl::fmg {

/// True where the nodes of a line contact are taken side by side: not in the linear model problems.
bool along_one_line(const Hierarchy& hierarchy, const Level& level);

/// What coefficients.cpp makes station by station, all along the line at once: the same bits. A station of a line has
/// one node, and vector registers would stay empty.
void coefficients_along_line(Hierarchy& hierarchy, Level& level);
/// update_film() of it.
void film_along_line(Hierarchy& hierarchy, Level& level);

}  // namespace ehl::fmg
