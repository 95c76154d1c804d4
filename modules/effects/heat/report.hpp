#pragma once
// Results of a thermal solution: temperatures with places and errors, fields, Nahme number.
#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// Everything but the film and the time. in: temperature, pressure and film on the finest grid; rows of all grids.
Solution report(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P,
                const core::Field& H, const thermal::Setup& setup, const thermal::Balance& balance,
                std::vector<Row> rows);

}  // namespace ehl::heat
