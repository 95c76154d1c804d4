#pragma once
// An effect that exists in this test alone: the steepest pressure along x. It counts how often the pipeline calls it.
#include "steady/solution.hpp"

namespace ehl::program {

/// Calls of each stage.
struct ToyCalls {
  int scene = 0, film = 0, after_solution = 0;
};
ToyCalls& toy_calls();

/// Largest |dP/dX| between neighbouring nodes.
double steepest(const steady::Solution& solution);

}  // namespace ehl::program
