#pragma once
// Error bars of the numbers that the observer of a scene computes, such as friction coefficients.
#include <vector>

#include "multigrid/record.hpp"
#include "steady/error_bars.hpp"

namespace ehl::steady {

struct Scene;

/// Relative error of each observed number in the last row, estimated from its values on all levels
/// (judgement/error_estimate.hpp). A number that is zero on all levels has the error 0.
/// in: spike_unresolved as in ErrorBars.
/// out: NaN with one level, or if the changes grow from level to level, as with a viscous oil under a pressure spike.
std::vector<double> errors_of_observed(const Scene& scene, const std::vector<multigrid::LevelRow>& levels,
                                       bool spike_unresolved);

}  // namespace ehl::steady
