#pragma once
// The factors by which temperature changes the coefficients (film::FactorFields), on a level and the grids that correct
// it: I0 on the fluidity, M2/I0 (times the thinning by the pressure flow) on the flow driven by pressure, and C on what
// the surfaces carry.
#include <cstddef>

#include "multigrid/hierarchy.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::heat {

/// Factors of 1 on levels[l] and the grids that correct it.
void reset_factors(multigrid::Hierarchy& hierarchy, std::size_t l);

/// Factors on levels[l] from those of the next coarser level, by bilinear interpolation; then on the grids that correct
/// it.
void interpolate_factors(multigrid::Hierarchy& hierarchy, std::size_t l);

/// Weighted geometric mean of new and old factors on levels[l]: ln f = weight ln f_film + (1 - weight) ln f. Full
/// weighting carries I0 and M2/I0 to the grids that correct the level, injection carries C. returns the largest change
/// of ln M2 that the film requires.
double take_factors(multigrid::Hierarchy& hierarchy, std::size_t l, const thermal::FilmTemperature& film,
                    double weight);

}  // namespace ehl::heat
