#pragma once
// Artificial solutions, which cost no time, for tests of the functions that use solutions.
#include <limits>
#include <vector>

#include "contact/groups.hpp"
#include "steady/accuracy.hpp"

namespace ehl::test {

using namespace steady;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Artificial solutions H = limit (1 + mesh h^2 + inlet/length^3 + load/length + kink) on three levels, and the
/// record of the scenes asked for.
struct Made {
  double mesh = 0.5;          ///< relative error of Hc divided by h^2
  double mesh_of_Hm = 2.0;    ///< the same for Hm, divided by `mesh`
  double inlet = 0.0;         ///< relative error of Hc times length^3; negative: the film grows with the domain
  double load = 0.0;          ///< relative error of Hc times length
  double domain_of_Hm = 1.0;  ///< error of the domain in Hm, divided by that in Hc
  double kink_of_Hc = 0.0;    ///< relative disturbance of the second finest level
  double kink_of_Hm = 0.0;
  double algebraic = 0.0;    ///< relative error left by the cycles
  int diverges_from = 1000;  ///< number of cells from which on there is no solution
  std::vector<Scene> asked{};

  Solution operator()(const Scene& scene) {
    asked.push_back(scene);
    Solution solution;
    solution.grid = scene.grid;
    solution.P = core::Field(scene.grid);
    // There is no state to continue from, so the next grid is artificial too.
    solution.P.fill(unknown);
    solution.converged = scene.grid.nx < diverges_from;
    solution.failed_check = solution.converged ? "" : "made up to fail";
    const double length = scene.grid.X_b - scene.grid.X_a;
    for (const int coarser : {4, 2, 1}) {
      LevelRow row;
      row.nx = scene.grid.nx / coarser;
      const double h = length / row.nx;
      const double of_domain = inlet / (length * length * length) + load / length;
      const bool kinked = coarser == 2;
      row.Hc = 0.4 * (1.0 + mesh * h * h + of_domain + (kinked ? kink_of_Hc : 0.0));
      row.Hm = 0.3 * (1.0 + mesh_of_Hm * mesh * h * h + domain_of_Hm * of_domain + (kinked ? kink_of_Hm : 0.0));
      row.Hm_fitted = row.Hm;
      row.P_max = 1.0;
      row.mesh_error_Hc = 1.25 * mesh * h * h;
      row.mesh_error_Hm = mesh_of_Hm * row.mesh_error_Hc;
      solution.levels.push_back(row);
    }
    solution.verification.algebraic_error_Hc = algebraic;
    solution.verification.algebraic_error_Hm = algebraic;
    solution.error_bars = error_bars_of(scene, solution);
    return solution;
  }
};

/// h = 6/64 on the first grid: for mesh = 0.5 the estimate for Hm is 1.1 %, and a quarter of that on every finer grid.
inline Scene scene_for(double error) {
  const contact::Groups groups = contact::from_moes(20.0, 10.0);
  const double p_h = groups.alpha_bar / 2.2e-8;
  Scene scene;
  scene.contact = steady::scales_of(20.0, 10.0);
  scene.lambda = groups.lambda;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = {64, 64, -4.5, 1.5, -3.0, 3.0};
  scene.accuracy.error = error;
  scene.accuracy.most_cells = 256;
  return scene;
}
constexpr double first_error = 2.5 * 0.5 * 36.0 / 4096.0;

inline Solution run(const Scene& scene, Made& made) {
  const SolveOnGrid solve = [&made](const Scene& one) { return made(one); };
  return solve_to_accuracy(scene, solve, {});
}

inline std::vector<int> cells(const Made& made) {
  std::vector<int> result;
  for (const Scene& scene : made.asked) result.push_back(scene.grid.nx);
  return result;
}

}  // namespace ehl::test
