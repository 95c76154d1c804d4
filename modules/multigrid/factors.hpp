#pragma once
// The factors of an effect on the coefficients (film::FactorFields), on a level and the grids that correct it.
#include <cstddef>

#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// Carries the factors of levels[l] to the grids that correct it: those on fluidity and mobility by full weighting,
/// that on what the surfaces carry by injection. limits: the film model has factors.
void restrict_factors(Hierarchy& hierarchy, std::size_t l);

/// Sets the factors on levels[l], and by restriction those on the grids that correct it.
void set_factors(Hierarchy& hierarchy, std::size_t l, const film::FactorFields& factors);

}  // namespace ehl::multigrid
