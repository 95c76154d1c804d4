#pragma once
// The base case solved with heat: the isothermal film, then the iterations between film and heat.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>

#include "effects/heat/passes.hpp"
#include "steady/multigrid_solve.hpp"
#include "unit/thermal/base_case.hpp"

namespace support {

/// The line contact of gear teeth: 0.8 GPa, 10 m/s.
inline BaseCase teeth() {
  BaseCase base;
  base.line = true;
  base.load = 2e5;
  base.R = 0.010;
  base.u_m = 10.0;
  base.srr = 0.4;
  base.eta0 = 0.0165;
  base.alpha = 18e-9;
  return base;
}

inline ehl::steady::Scene scene_of(const BaseCase& base, const ehl::thermal::Setup& setup,
                                   const ehl::core::Grid& grid) {
  ehl::steady::Scene scene;
  const double U = base.eta0 * base.u_m / (base.E_prime * base.R);
  const double W = base.load / (base.E_prime * base.R * (base.line ? 1.0 : base.R));
  scene.contact = ehl::steady::scales_of(W * std::pow(2 * U, base.line ? -0.5 : -0.75),
                                         base.alpha * base.E_prime * std::pow(2 * U, 0.25),
                                         base.line ? ehl::contact::line_contact() : ehl::contact::Ellipse{});
  scene.lambda = setup.lambda;
  scene.viscosity = setup.viscosity;
  scene.density = setup.density.at_T0;
  scene.thinning = setup.thinning;
  scene.grid = grid;
  scene.deformation.method = ehl::mlmi::Method::fft;
  return scene;
}

struct Found {
  double Hc_cold = 0, Hm_cold = 0, Hc = 0, Hm = 0, mu = 0, film = 0, surface_1 = 0, surface_2 = 0, C_centre = 0;
  ehl::heat::Result result{};
};
/// change: changes the heat of the base case. look: receives the film temperature and the level at the end.
template <class Change, class Look>
Found solve(const BaseCase& base, const ehl::core::Grid& grid, Change change, double share, Look look) {
  const ehl::core::Patch half = base.line ? ehl::core::Patch(grid) : ehl::core::lower_half(grid);
  ehl::thermal::Setup setup = base.setup(half);
  change(setup);
  ehl::steady::Scene scene = scene_of(base, setup, grid);
  scene.has_factors = true;
  ehl::multigrid::Run run = ehl::steady::begin_multigrid(scene, {}, {});
  BOOST_REQUIRE((run.hierarchy.finest().grid == half));
  ehl::multigrid::full_multigrid(run);
  Found found;
  const ehl::judgement::Measures cold = ehl::multigrid::measures_of(run.hierarchy, run.finest());
  found.Hc_cold = cold.Hc;
  found.Hm_cold = cold.Hm;
  ehl::thermal::FilmTemperature film(setup);
  const ehl::heat::Parameters parameters{.share = share, .error = run.record.levels.back().mesh_error_Hc};
  found.result = ehl::heat::heat_up(run, run.finest(), film, parameters);
  const ehl::heat::Pass& last = found.result.passes.back();
  const ehl::thermal::Balance& balance = found.result.balance;
  found.Hc = last.Hc;
  found.Hm = last.Hm;
  found.mu = balance.friction;
  found.film = base.T0 * balance.film.theta;
  found.surface_1 = base.T0 * balance.surface_1.theta;
  found.surface_2 = base.T0 * balance.surface_2.theta;
  found.C_centre = film.C()(half.nx * 3 / 4, half.ny);
  look(film, run.hierarchy.finest());
  return found;
}
template <class Change>
Found solve(const BaseCase& base, const ehl::core::Grid& grid, Change change, double share = 0.1) {
  return solve(base, grid, change, share, [](const ehl::thermal::FilmTemperature&, const ehl::multigrid::Level&) {});
}
inline ehl::core::Grid square(int n) { return {n, n, -4.5, 1.5, -3.0, 3.0}; }
inline ehl::core::Grid along(int n) { return ehl::core::line_grid(n, -4.5, 1.5); }

}  // namespace support
