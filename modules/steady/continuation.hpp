#pragma once
// Load continuation: a high load reached from lower ones.
#include <functional>
#include <vector>

#include "steady/multigrid_solve.hpp"

namespace ehl::steady {

/// A scene with another load but the same speeds, materials, lubricant and radii. M is proportional to the load, L
/// does not depend on it, and p_h is proportional to its cube root (square root for a line contact). The domain keeps
/// its size in Hertz radii. in: M > 0.
Scene under_load(const Scene& scene, double M);

/// A solution by load continuation, on the first grid that resolves the contact or else the finest.
/// First load: solved by first_load(); if it fails and the deck does not prescribe it, a load three times as high. Then
/// one load after another, each by cycles to a small residual from the last pressure and an H00 predicted from the last
/// two films. The step in ln M grows while few cycles are needed and is halved if the cycles fail. At the load of the
/// scene the full multigrid continues to the finest grid.
/// out: as solve_by_multigrid(); `steps` has a row for every step, the rejected ones included, also if an error is
/// thrown. errors: core::SolverError if no first load can be solved, the steps become too small or too many, or a finer
/// grid diverges; core::Interrupted.
Solution solve_by_continuation(const Scene& scene, const Start& start,
                               const std::function<Solution(const Scene& light)>& first_load,
                               const ProgressCallback& progress, std::vector<ContinuationStep>& steps);

}  // namespace ehl::steady
