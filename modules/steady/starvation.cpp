#include "steady/starvation.hpp"

#include <algorithm>

#include "core/constants.hpp"
#include "judgement/measures.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

double carried_at_centre(const Scene& scene, const Solution& solution) {
  const double P = judgement::value_at(solution.grid, solution.P, 0.0, 0.0);
  double rho = 1.0;
  rheology::density(scene.density, {&P, 1}, {&rho, 1});
  return solution.C_centre * rho * judgement::value_at(solution.grid, solution.H, 0.0, 0.0);
}

double meniscus_on(const Solution& solution, int j) {
  const core::Grid& grid = solution.grid;
  int i = 1;
  while (i < grid.nx && solution.P(i, j) <= 0.0) ++i;
  const double layer = solution.Q(0, j);
  const double full = solution.H(i - 1, j);  // P = 0 there
  const double share = full > layer ? std::clamp((solution.Q(i - 1, j) - layer) / (full - layer), 0.0, 1.0) : 1.0;
  return std::max(grid.X_a, grid.X(i) - grid.hx() * (0.5 + share));
}

Starvation starvation_of(const Scene& scene, const Solution& starved, const Solution& flooded) {
  const core::Grid& grid = starved.grid;
  Starvation result;
  // Ratios to a flooded contact that did not converge are unknown.
  const double carried = flooded.converged ? carried_at_centre(scene, flooded) : core::unknown;
  result.supply_ratio = (starved.passes.empty() ? scene.supply(0.0) : starved.passes.back().supply) / carried;
  result.factor = carried_at_centre(scene, starved) / carried;
  result.Hc_flooded = flooded.converged ? flooded.levels.back().Hc : core::unknown;
  result.Hm_flooded = flooded.converged ? flooded.levels.back().Hm : core::unknown;
  result.flooded_converged = flooded.converged;
  result.line = grid.line;
  result.meniscus_X = meniscus_on(starved, grid.ny / 2);
  result.cells_to_inlet = grid.nx;
  int full = 0;
  for (int j = 0; j <= grid.ny; ++j) {
    if (starved.theta(0, j) >= 1.0) ++full;
    for (int i = 1; i < result.cells_to_inlet; ++i)
      if (starved.P(i, j) > 0.0) result.cells_to_inlet = i;
  }
  result.filled = static_cast<double>(full) / grid.nodes_y();
  result.in = starved.oil.in;
  result.through = starved.verification.flow_through;
  result.aside = starved.oil.aside;
  result.imbalance = starved.oil.imbalance();
  return result;
}

}  // namespace ehl::steady
