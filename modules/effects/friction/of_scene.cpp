#include "effects/friction/of_scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/norms.hpp"
#include "effects/friction/beyond.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::friction {
namespace {

// The mass flow rho_bar H at the pressure maximum, where the flow by the pressure gradient is zero.
double flow_of(const steady::Scene& scene, const steady::SolvedFilm& film) {
  const core::Location highest = core::maximum(film.P);
  double rho_bar = 1.0;
  rheology::density(scene.density, {&highest.value, 1}, {&rho_bar, 1});
  return rho_bar * film.H(highest.i, highest.j);
}

// The state of the far field upstream of a line contact. Heat reduces the pressure there as a lower speed would, at the
// same flow. The equivalent speed is the one with which the far field has the solved pressure at the first node.
reynolds::FarState state_upstream(const reynolds::FarField& field, const steady::Scene& scene,
                                  const steady::SolvedFilm& film) {
  reynolds::FarState state{.H00 = film.H00, .flow = flow_of(scene, film)};
  const double there = film.P(0, 1);
  if (film.I0 == nullptr || there <= 0.0) return state;
  constexpr int rounds = 30;  // fixed-point iteration; its contraction factor is alpha P, which is small in the inlet
  for (int k = 0; k < rounds; ++k)
    if (const double P = field.P(field.at(film.grid.X_a, 0.0), film.H(0, 1), state); P > 0.0) state.speed *= there / P;
  return state;
}

}  // namespace

bool oil_outside(const steady::Scene& scene) { return scene.far_field && !scene.supply; }

Surroundings::Surroundings(const steady::Scene& scene, const reynolds::FarField* far_field, const core::Grid& domain,
                           double meniscus)
    : far_field_(scene.supply ? nullptr : far_field) {
  if (far_field_ == nullptr) return;
  deformation_ = steady::geometry_of(scene).kernel.factor * contact::load(scene.contact.shape);
  if (!domain.line) quadrature_.emplace(*far_field_, contact::gap(scene.contact.shape), domain, meniscus);
}

Friction friction_at(const steady::Scene& scene, const steady::SolvedFilm& film, const Surroundings& around,
                     const reynolds::FarState& state, Parameters parameters) {
  std::optional<rheology::ShearThinning> thinning = scene.thinning;
  if (thinning && !std::isnan(parameters.thinning_k)) thinning->k = parameters.thinning_k;
  Film of{.grid = film.grid,
          .P = film.P,
          .H = film.H,
          .viscosity = scene.viscosity,
          .thinning = thinning,
          .I0 = film.I0,
          .less_tau = film.less_tau,
          .load = contact::load(scene.contact.shape),
          .gap = contact::gap(scene.contact.shape),
          .lambda = scene.lambda,
          .P_c = film.P_c,
          .starved = bool(scene.supply)};
  if (around.far_field() == nullptr) {
    if (!scene.supply && std::isinf(parameters.meniscus))
      parameters.outer_X = -std::max(-0.5 * scene.grid.X_a, contact::extent(scene.contact.shape).X);
    return friction_of(of, parameters);
  }
  const Outside outside{*around.far_field(), of.gap, around.deformation() * state.load, state, around.quadrature()};
  of.outside = &outside;
  return friction_of(of, parameters);
}

Friction friction_of(const steady::Scene& scene, const steady::SolvedFilm& film, Parameters parameters) {
  if (!oil_outside(scene)) return friction_at(scene, film, {}, {}, parameters);
  const reynolds::FarField field = steady::far_field(scene, contact::load(scene.contact.shape), film.grid);
  const reynolds::FarState state =
      film.grid.line ? state_upstream(field, scene, film) : reynolds::FarState{.H00 = film.H00};
  return friction_at(scene, film, {scene, &field, film.grid, parameters.meniscus}, state, parameters);
}

}  // namespace ehl::friction
