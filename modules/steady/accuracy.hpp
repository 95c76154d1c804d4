#pragma once
// An accuracy instead of a grid: domain and level that bring the estimated error of Hc and Hm below it.
#include <functional>
#include <vector>

#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// Solves a scene on the grid that it names.
using SolveOnGrid = std::function<Solution(const Scene&)>;

/// Solutions from grid to grid until the estimated relative error of Hc and Hm is at most scene.accuracy.error.
///   Domain, where it is free: coarse solutions of the same mesh on it, on one twice as large and (where that takes no
///   more than 1024 cells) on one four times as large tell what the inlet cuts off, which falls with the third power
///   of the size, and what load is missing, which falls with the first; it grows until half of the target is left for
///   the mesh, or three tenths where half takes a domain that is too large.
///   Mesh: the scheme's order foretells the level; the climb goes there from the last solution. The promise is for the
///   values that are shown first (ErrorBars::Hc_best), else for the plain ones of the finest grid (node minimum) as far
///   as most_cells and most_nodes allow, and for the values extrapolated from the levels beyond that. Where the plain
///   ones are not as close: AccuracyReport::by_extrapolation.
/// A domain that the deck fixes is part of the problem: its error is told, and not counted.
/// in: climbs, false: every grid is solved anew, as where solve_on_grid does more than cycles.
/// out: as of solve(), of the last grid; where the target is not met it is marked as not converged, and
/// AccuracyReport::stopped_by says what stood in the way. The level table has all levels. errors: as of solve().
Solution solve_to_accuracy(const Scene& scene, const SolveOnGrid& solve_on_grid, const ProgressCallback& progress,
                           bool climbs = true);

/// What is solved for the error of a domain that is free: coarse scenes on domains of one, two and four times the size.
std::vector<Scene> domain_series(const Scene& scene);

}  // namespace ehl::steady
