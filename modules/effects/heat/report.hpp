#pragma once
// What a thermal solution tells: temperatures with their places and errors, fields, Nahme's number.
#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// All of a solution but its film and its time. in: the temperature, pressure and film of the finest grid; rows of all
/// grids.
Solution report(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P,
                const core::Field& H, const thermal::Setup& setup, const thermal::Balance& balance,
                std::vector<Row> rows);

}  // namespace ehl::heat
