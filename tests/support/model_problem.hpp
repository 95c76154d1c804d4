#pragma once
// The linear model problems of the paper (eqs. 9, 10, 19, 20), with the grids, the relaxation and
// the cycles of the solver.
#include <functional>
#include <vector>

#include "multigrid/hierarchy.hpp"

namespace ehl::tests {

struct ModelProblem {
  int cells = 128;  ///< along x and y, on [-4.5, 1.5] x [-3, 3]/stretch
  double stretch = 1.0;
  int coarsest = 8;  ///< cells of the coarsest grid, as in the paper
  std::function<double(double, double)> epsilon;
  reynolds::Wedge wedge = reynolds::Wedge::upstream1;
  multigrid::Cycle cycle = multigrid::Cycle::W;
  multigrid::RelaxationParameters relaxation = linear_relaxation();

  /// The relaxation of the solver without the damping, which only the nonlinear problem needs.
  static multigrid::RelaxationParameters linear_relaxation();
};

/// epsilon = e h^2 everywhere; h is the mesh size of the finest grid.
ModelProblem constant_epsilon(double e, int cells, reynolds::Wedge wedge, multigrid::Cycle cycle);

/// epsilon = e hx hy everywhere, on cells of hx = stretch hy.
ModelProblem constant_epsilon_on_stretched_cells(double e, double stretch, int cells, reynolds::Wedge wedge,
                                                 multigrid::Cycle cycle);

/// Eq. (20): epsilon = (X^2 + Y^2)^3/8 outside the circle of radius 1, 0 inside.
ModelProblem papers_epsilon(int cells, reynolds::Wedge wedge, multigrid::Cycle cycle);

/// Grids of the problem with f = 0 and without the geometry term of the film. P = 0 is then the
/// solution, and P is the error.
multigrid::Hierarchy make_error_hierarchy(const ModelProblem& problem);

/// The convergence factor of each V(2,1) or W(2,1) cycle (root mean square of P). The initial error is random,
/// but the same in every run.
std::vector<double> error_factors(const ModelProblem& problem, int cycles);

/// The geometric mean of the last `count` factors.
double late_factor(const std::vector<double>& factors, int count);

}  // namespace ehl::tests
