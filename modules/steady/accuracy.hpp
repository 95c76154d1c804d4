#pragma once
// A required accuracy instead of a grid: finds the domain and the level whose estimated error of Hc and Hm is below it.
#include <functional>
#include <vector>

#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// Solves a scene on the grid that it prescribes.
using SolveOnGrid = std::function<Solution(const Scene&)>;

/// Solves on finer and finer grids until the estimated relative error of Hc and Hm is at most scene.accuracy.error.
///   Domain, if it may grow: solutions on a coarse mesh on this domain, on one twice as large and, up to 1024 cells, on
///   one four times as large. Two losses are fitted to them: that of inlet pressure, which falls with the third power
///   of the size, and that of load, which falls with the first. The domain grows until half of the target is left for
///   the mesh, or three tenths if half needs too large a domain.
///   Mesh: the order of the scheme predicts the level, and full multigrid continues to it from the last solution. The
///   target applies to the best values (ErrorBars::Hc_best); without those to the nodal values of the finest grid, as
///   far as most_cells and most_nodes allow, and beyond that to the extrapolated values.
///   AccuracyReport::by_extrapolation is set if the nodal values do not meet it.
/// A domain that the deck fixes is part of the problem: its error is reported but not counted.
/// in: reuses_coarse; false: every grid is solved from its own start, as required if solve_on_grid does more than
/// cycles. out: as of solve(), on the last grid. If the target is not met the solution is marked as not converged, and
/// AccuracyReport::stopped_by says why. The level table has all levels. errors: as of solve().
Solution solve_to_accuracy(const Scene& scene, const SolveOnGrid& solve_on_grid, const ProgressCallback& progress,
                           bool reuses_coarse = true);

/// The coarse scenes from which the error of a free domain is estimated: domains of one, two and four times the size.
std::vector<Scene> domain_series(const Scene& scene);

}  // namespace ehl::steady
