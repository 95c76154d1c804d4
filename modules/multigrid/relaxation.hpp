#pragma once
#include <algorithm>

#include "multigrid/hierarchy.hpp"
#include "reynolds/row.hpp"

namespace ehl::multigrid {

/// One sweep of the hybrid line relaxation, with the Y sweep where that applies, then the film and the coefficients of
/// the new pressure.
///
/// Lines of constant Y are visited in two colours, the odd ones and then the even ones. Each line solves its equations
/// (22)-(25) for all changes at once. The changes of a colour are applied, distributed where the point is distributive,
/// before the other colour is relaxed, so that the second colour sees the new pressures of the first in the Poiseuille
/// terms. The elastic film is renewed once, after both. With this order distributive lines are stable for every epsilon
/// with a weight near one; Jacobi order needs far more damping.
///
/// Kind of a point: single (Gauss-Seidel) where e_max sqrt(e_max/e_min) > crossover with e = epsilon/h^2 at the four
/// half points, else distributive. For smooth epsilon this is the paper's rule. Where epsilon varies by orders from
/// cell to cell, a distributed change would put a share of itself on a neighbour with far stronger coupling.
///
/// errors: core::SolverError on a vanishing pivot (grid, line, point).
void relax(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);
inline void relax(Hierarchy& hierarchy, Level& level) { relax(hierarchy, level, hierarchy.parameters.relaxation); }

/// The X sweep alone. The film and the coefficients stay as they were.
void relax_pressure(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how);

/// Crossover of a grid: the epsilon/h^2 above which the coupling by epsilon outweighs that by the film.
inline double crossover_on(const Hierarchy& hierarchy, const core::Patch& grid, const RelaxationParameters& how) {
  const double crossover = std::max(how.crossover, how.least_single_epsilon / (grid.hx() * grid.hx()));
  return crossover * reynolds::relative_strength(hierarchy.transport, grid.hx());
}

}  // namespace ehl::multigrid
