#pragma once
// What a thermal solution tells: temperatures with their places and errors, fields, Nahme's number.
#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// True where the highest temperature of all the film or surface is that under the spike.
bool hottest_under_spike(const std::vector<Row>& rows, double Row::*value, double Row::*behind);

/// All of a solution but its film and its time. in: the temperature, pressure and film of the finest grid; rows of all
/// grids.
Solution report(const thermal::FilmTemperature& film, const core::Patch& patch, const core::Field& P,
                const core::Field& H, const thermal::Setup& setup, const thermal::Balance& balance,
                std::vector<Row> rows);

}  // namespace ehl::heat
