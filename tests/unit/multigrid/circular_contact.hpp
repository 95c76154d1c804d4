#pragma once
// The circular contact as a multigrid problem, and test states for it.
#include <cmath>

#include "contact/groups.hpp"
#include "multigrid/start.hpp"
#include "support/random.hpp"

namespace ehl::tests {

/// Roelands (z = 0.6) and Dowson-Higginson at the Hertz pressure of a mineral oil.
inline multigrid::Problem circular_contact(double M, double L, reynolds::Wedge wedge,
                                           reynolds::Face face = reynolds::Face::mean) {
  const contact::Groups groups = contact::from_moes(M, L);
  constexpr double alpha = 1.7e-8;
  const double p_h = contact::hertz_pressure(groups, alpha);
  multigrid::Problem problem;
  problem.film.lambda = groups.lambda;
  problem.film.viscosity = rheology::make_roelands(alpha, rheology::roelands_p0, 0.6, p_h);
  problem.film.density = rheology::make_dowson_higginson(p_h);
  problem.transport = wedge;
  problem.face = face;
  return problem;
}

/// A rough state as in the middle of a solution: pressures with noise, a third of the nodes outside the contact
/// cavitated, and right-hand sides in both equations.
inline void set_rough_state(multigrid::Hierarchy& hierarchy, multigrid::Level& level, Random& random) {
  const core::Patch& grid = level.grid;
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j < grid.ny; ++j) {
      const double X = grid.X(i);
      const double Y = grid.Y(j);
      const double hertz = std::sqrt(std::max(0.0, 1.0 - X * X - Y * Y));
      const double tail = 0.05 * std::exp(-0.5 * (X * X + Y * Y)) + random.between(0.0, 0.02);
      level.P(i, j) = hertz > 0.0 ? hertz * random.between(0.9, 1.1) : random.chance(0.33) ? 0.0 : tail;
    }
  level.F = random_field(grid, random, 0.0, 0.02);
  level.f = random_field(grid, random, -0.1, 0.1);
  hierarchy.H00 = -0.6;
  multigrid::update_film(hierarchy, level);
}

}  // namespace ehl::tests
