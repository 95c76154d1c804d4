#pragma once
// What a thermal solution tells: temperatures with their places and errors, fields, Nahme's number.
#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// True where the highest temperature under a spike, as it grows from grid to grid, may get above that of all the film
/// or surface. in: two rows or more; else false.
bool may_be_hottest(const std::vector<Row>& rows, double Row::*value, double Row::*behind);

/// All of a solution but its film and its time. in: the temperature, pressure and film of the finest grid; rows of all
/// grids.
Solution report(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P,
                const core::Field& H, const thermal::Setup& setup, const thermal::Balance& balance,
                std::vector<Row> rows);

}  // namespace ehl::heat
