#pragma once
// The contact that most tests of the solvers begin with.
#include "contact/groups.hpp"
#include "steady/scene.hpp"

namespace ehl::tests {

/// M and L with Roelands (z = 0.68, alpha = 2.2e-8 1/Pa) and Dowson-Higginson.
inline steady::Scene roelands_scene(double M, double L, const core::Grid& grid) {
  steady::Scene scene;
  const contact::Groups groups = contact::from_moes(M, L);
  scene.M = M;
  scene.L = L;
  scene.lambda = groups.lambda;
  const double p_h = groups.alpha_bar / 2.2e-8;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  scene.grid = grid;
  return scene;
}

}  // namespace ehl::tests
