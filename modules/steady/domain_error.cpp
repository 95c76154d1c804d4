#include "steady/domain_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/groups.hpp"
#include "core/errors.hpp"
#include "steady/climb.hpp"

namespace ehl::steady {
namespace {

constexpr double tolerance = 1e-4;
/// Cells along x of the scene's own domain in the two coarse solutions, at least.
constexpr int fewest_cells = 32;

double central_film(const Scene& scene) {
  const Start start{.cells = scene.grid.nx, .sweeps = 20, .cycles = 2, .coarsest = fewest_cells};
  const Solution solution = climb(scene, start, {});
  return solution.converged ? solution.levels.back().Hc : std::numeric_limits<double>::quiet_NaN();
}

double rough_error(double lambda, double alpha_bar, double X_a) {
  const double cut_off = 4.0 / 3.0 * lambda / std::abs(X_a * X_a * X_a);
  return 0.5 * cut_off * std::max(alpha_bar, 10.0);
}

}  // namespace

double rough_domain_error(const Scene& scene) {
  return rough_error(scene.lambda, contact::from_moes(scene.M, scene.L).alpha_bar, scene.grid.X_a);
}

double chosen_inlet(double lambda, double alpha_bar, double X_b) {
  constexpr double target = 0.006;
  constexpr int shortest = 20;
  constexpr int longest = 31;
  const auto inlet = [X_b](int m) { return -X_b * m / (32.0 - m); };
  int m = shortest;
  while (m < longest && rough_error(lambda, alpha_bar, inlet(m)) > target) ++m;
  return inlet(m);
}

double estimate_domain_error(const Scene& scene) {
  Scene coarse = scene;
  while (coarse.grid.nx >= 2 * fewest_cells && coarse.grid.nx % 2 == 0 && coarse.grid.ny % 2 == 0)
    coarse.grid = core::coarsened(coarse.grid);
  coarse.deformation = {};
  coarse.multigrid = {};
  coarse.multigrid.tolerance = tolerance;
  Scene longer = coarse;
  longer.grid.nx *= 2;
  longer.grid.ny *= 2;
  longer.grid.X_a -= scene.grid.X_b - scene.grid.X_a;
  longer.grid.Y_a *= 2.0;
  longer.grid.Y_b *= 2.0;
  try {
    return central_film(longer) / central_film(coarse) - 1.0;
  } catch (const core::SolverError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace ehl::steady
