#include "case/film_solution.hpp"

#include <utility>

#include "case/effects.hpp"
#include "case/sliding_input.hpp"

namespace ehl::program {
namespace {

thermal::Setup setup_of(const Case& input) {
  if (input.heat) return input.heat->setup;
  thermal::Setup setup = thermal::cold_setup(input.scene.viscosity, input.scene.density);
  setup.lambda = input.scene.lambda;
  setup.srr = input.physics.srr;
  setup.stress_of_P = 1.0 / stress_of_speed(input.physics);
  setup.thinning = input.scene.thinning;
  setup.flow_thinning = input.flow_thinning;
  if (input.friction) setup.limit = input.friction->limit;
  return setup;
}

}  // namespace

FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress) {
  FilmSolution solution{.film = steady::solve(input.scene, progress)};
  if (!(input.heat || input.flow_thinning) || !solution.film.converged) return solution;
  const steady::Solution& before = solution.film;
  HeatResult result;
  result.Hc_isothermal = before.levels.back().Hc;
  result.Hm_isothermal = before.levels.back().Hm;
  result.mu_isothermal = friction_of(input, before, nullptr).sliding;
  result.found = heat::solve(input.scene, setup_of(input), before, progress);
  solution.film = std::move(result.found.film);
  result.found.film = {};
  result.mu = friction_of(input, solution.film, &result.found.fields).sliding;
  (input.heat ? solution.heat : solution.flow) = std::move(result);
  return solution;
}

}  // namespace ehl::program
