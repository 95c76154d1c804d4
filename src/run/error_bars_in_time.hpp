#pragma once
// Error bars of a run in time, from two more runs.
#include "case/effects.hpp"

namespace ehl::program {

/// Runs the case again on half the cells, and there with ten times the tolerance and twice the longest step. The first
/// difference estimates the error of the mesh, the second that of the time steps. Fills the error bars of the rows and
/// those of extremes and means; does nothing if the deck asks for none, or if the run is incomplete. If one of the two
/// runs fails or is stopped, no bar is known, and TimeErrors::missing says why.
void add_error_bars_in_time(const Case& input, RunSettings& settings, Computed& computed);

}  // namespace ehl::program
