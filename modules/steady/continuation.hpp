#pragma once
// Load continuation: a high load reached from lower ones.
#include <functional>
#include <vector>

#include "steady/climb.hpp"

namespace ehl::steady {

/// The scene under another load: speeds, materials, lubricant and radii as they are. M is proportional to the load, L
/// does not depend on it; p_h goes with its cube root. The domain keeps its size in Hertz radii.
/// in: M > 0.
Scene under_load(const Scene& scene, double M);

/// The solution by load continuation. On the first grid that holds the contact, or the finest: first_load() for the
/// first load, three times as heavy a one where it is not solved and the deck does not say it; then one load after
/// another, from the last pressure and an H00 that follows the film of the last two, cycles until the state is solved
/// to a small residual. The step in ln M grows while the cycles are few and is halved where they fail. At the load of
/// the scene the climb goes on to the finest grid.
/// out: as climb(); steps has a row for every step, rejected ones included, also where an error is thrown.
/// errors: core::SolverError where no first load can be solved, the steps become too small or too many, or a finer grid
/// diverges; core::Interrupted.
Solution climb_by_load(const Scene& scene, const Start& start,
                       const std::function<Solution(const Scene& light)>& first_load, const ProgressCallback& progress,
                       std::vector<ContinuationStep>& steps);

}  // namespace ehl::steady
