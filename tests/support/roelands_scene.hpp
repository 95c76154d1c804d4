#pragma once
// The contact that most solver tests use.
#include "contact/groups.hpp"
#include "steady/domain_error.hpp"
#include "steady/scene.hpp"

namespace ehl::tests {

/// M and L with Roelands (z = 0.68, alpha = 2.2e-8 1/Pa) and Dowson-Higginson; for L = 0 isoviscous and incompressible.
inline steady::Scene roelands_scene(double M, double L, const core::Grid& grid, const contact::Ellipse& shape = {}) {
  steady::Scene scene;
  scene.contact = steady::scales_of(M, L, shape);
  const contact::Groups groups = contact::from_moes(M, L, shape);
  scene.lambda = groups.lambda;
  scene.grid = grid;
  if (L == 0.0) return scene;
  const double p_h = groups.alpha_bar / 2.2e-8;
  scene.viscosity = rheology::make_roelands(2.2e-8, rheology::roelands_p0, 0.68, p_h);
  scene.density = rheology::make_dowson_higginson(p_h);
  return scene;
}

/// The corresponding line contact with the default discretization.
inline steady::Scene roelands_line(double M, double L, const core::Grid& grid) {
  steady::Scene scene = roelands_scene(M, L, grid, contact::line_contact());
  scene.wedge = reynolds::Wedge::upstream3;
  scene.face = reynolds::Face::logmean_bounded;
  scene.adjoint_errors = false;
  return scene;
}
/// A line contact on the domain that a deck with M and L gets.
inline steady::Scene open_line(double M, double L, int cells) {
  const steady::Tuning tuning;
  const steady::ContactScales scales = steady::scales_of(M, L, contact::line_contact());
  const double X_b = steady::chosen_outlet(tuning, scales, tuning.error_of_closed_domain);
  const double X_a = steady::chosen_inlet(tuning, scales, X_b, tuning.error_of_closed_domain);
  steady::Scene scene = roelands_line(M, L, core::line_grid(cells, X_a, X_b));
  scene.far_field = true;
  return scene;
}

}  // namespace ehl::tests
