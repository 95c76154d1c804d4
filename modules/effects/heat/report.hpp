#pragma once
// Results of a thermal solution: temperatures with places and errors, fields, Nahme number.
#include "effects/heat/solve.hpp"

namespace ehl::heat {

/// Temperature, pressure and film on the finest grid.
struct Finest {
  const thermal::FilmTemperature& film;
  const core::Patch& patch;
  const core::Field& P;
  const core::Field& H;
  const thermal::Setup& setup;
};

/// Everything but the film and the time. in: rows of all grids.
Solution report(const Tuning& tuning, const judgement::Tuning& judged, const Finest& finest,
                const thermal::Balance& balance, std::vector<Row> rows);

}  // namespace ehl::heat
