#include "effects/roller/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "effects/roller/scene.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::roller {
namespace {

constexpr int fewest_cells = 64;  // of the coarser grid, so that the multigrid method can start on it

std::optional<steady::Solution> on_coarser_grid(steady::Scene scene, bool traced,
                                                const steady::ProgressCallback& progress) {
  if (scene.grid.nx < 2 * fewest_cells || scene.grid.nx % 2 != 0 || scene.grid.ny % 4 != 0) return std::nullopt;
  scene.grid = core::coarsened(scene.grid);
  scene.deformation = mlmi::fitting(scene.deformation, scene.grid);
  scene.adjoint_errors = scene.error_maps = false;
  if (scene.solver.coarsest_cells > scene.grid.nx) scene.solver.coarsest_cells = 0;
  if (traced) scene.one_start_only = "an error bar is worth one start";
  try {
    steady::Solution solution = steady::solve(scene, progress);
    return solution.converged ? std::optional(std::move(solution)) : std::nullopt;
  } catch (const core::SolverError&) {
    return std::nullopt;
  }
}

Distribution dry_distribution(const steady::Scene& scene, bool solved) {
  const core::Patch grid = steady::on_one_half(scene) ? core::lower_half(scene.grid) : core::Patch(scene.grid);
  dry::Problem problem = dry_problem(scene, grid);
  problem.parameters.tolerance = solved ? 1e-6 : 1e-3;  // without a film to compare with, it is coarser
  const dry::Solution dry = dry::solve(problem);
  return distribution(dry.grid, dry.P, dry.H);
}

Stresses stresses_of(const subsurface::StressField& field) {
  const auto mises = std::ranges::find(field.kept, subsurface::sigma_mises, &subsurface::Volume::quantity);
  if (mises == field.kept.end()) return {};
  Stresses found{0.0, 0.0};
  for (const core::Field& plane : mises->planes)
    for (int i = 0; i <= field.grid.nx; ++i)
      for (int j = 0; j <= field.grid.ny; ++j) {
        const double Y = field.grid.Y(j);
        if (near_end(field.grid, Y)) found.end = std::max(found.end, plane(i, j));
        if (std::abs(Y) <= 0.5 * field.grid.Y_b) found.middle = std::max(found.middle, plane(i, j));
      }
  return found;
}

Stresses coarser_stresses(const steady::Solution& coarser, const subsurface::StressField& finer, int threads) {
  subsurface::Parameters parameters = finer.parameters;
  parameters.most_cells = finer.grid.nx / 2;
  parameters.kept = {subsurface::sigma_mises};
  return stresses_of(subsurface::stress_below(coarser.grid, coarser.P, parameters, threads));
}

}  // namespace

Analysis analyse(steady::Scene scene, const steady::Solution& solution, bool traced,
                 const subsurface::StressField* stresses, const steady::ProgressCallback& progress) {
  const double began = core::now();
  Analysis result{.found = distribution(solution.grid, solution.P, solution.H),
                  .solved = solution.converged,
                  .pressures_settle = solution.error_bars.P_max_converging};
  scene.grid = solution.grid;  // the grid that was found for the accuracy
  scene.accuracy = {};
  // A contact that touches is given up: its dry contact would take as long as the film.
  if (!solution.converged && !scene.one_start_only.empty())
    result.dry.middle.P_max = result.dry.lower.P = result.dry.upper.P = core::unknown;
  else
    result.dry = dry_distribution(scene, solution.converged);
  // Without a solution of the contact, a coarser grid has nothing to compare with.
  std::optional<steady::Solution> coarser;
  if (solution.converged) coarser = on_coarser_grid(scene, traced, progress);
  if (coarser) result.coarser = distribution(coarser->grid, coarser->P, coarser->H);
  if (stresses) {
    result.mises = stresses_of(*stresses);
    if (coarser) result.mises_coarser = coarser_stresses(*coarser, *stresses, scene.threads);
  }
  result.seconds = core::now() - began;
  return result;
}

}  // namespace ehl::roller
