#include "effects/roller/scene.hpp"

#include <utility>

#include "contact/ellipse.hpp"
#include "multigrid/hierarchy.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::roller {
namespace {

// Tolerance of the dry start, well below the error that the oil film adds.
constexpr double tolerance_of_start = 1e-4;

}  // namespace

void lay(const Profile& profile, steady::Scene& scene) {
  scene.use_symmetry = scene.use_symmetry && symmetric(profile);
  scene.surface = [profile, carried = std::move(scene.surface)](const core::Patch& grid, core::Field& S) {
    if (carried)
      carried(grid, S);
    else
      S.fill(0.0);
    add_gap(profile, grid, S);
  };
  scene.dry = [only = scene](const core::Patch& grid, core::Field& P) {
    dry::Problem problem = dry_problem(only, grid);
    problem.parameters.tolerance = tolerance_of_start;
    const dry::Solution solution = dry::solve(problem);
    core::copy(core::on_patch(grid, solution.P), P);
    return solution.H00;
  };
}

dry::Problem dry_problem(const steady::Scene& scene, const core::Patch& grid) {
  const multigrid::Geometry geometry = steady::geometry_of(scene);
  dry::Problem problem{.grid = grid,
                       .gap = core::Field(grid),
                       .load = contact::load(scene.contact.shape),
                       .threads = scene.threads,
                       .kernel = geometry.kernel,
                       .outline = geometry.outline};
  scene.surface(grid, problem.gap);
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) problem.gap(i, j) += multigrid::rigid_gap(geometry, grid, 0.0, i, j);
  return problem;
}

}  // namespace ehl::roller
