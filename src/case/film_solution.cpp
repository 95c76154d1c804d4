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

// What the film with heat is beside the flooded one with heat.
steady::Starvation starvation_of(const Case& input, const heat::Solution& found, const thermal::Setup& setup,
                                 const steady::ProgressCallback& progress) {
  steady::Scene full = input.scene;
  full.supply = {};
  full.adjoint_errors = false;
  const steady::Solution cold = steady::solve(full, progress);
  if (!cold.converged) return steady::starvation_of(input.scene, found.film, cold, found.C);
  const heat::Solution warm = heat::solve(full, setup, cold, progress);
  return steady::starvation_of(input.scene, found.film, warm.film, found.C, warm.C);
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
  if (input.scene.supply) {
    const double seconds = before.starvation->seconds;
    result.found.film.starvation = starvation_of(input, result.found, setup_of(input), progress);
    result.found.film.starvation->seconds = seconds + result.found.seconds;
  }
  solution.film = std::move(result.found.film);
  result.found.film = {};
  result.mu = friction_of(input, solution.film, &result.found.fields).sliding;
  (input.heat ? solution.heat : solution.flow) = std::move(result);
  return solution;
}

}  // namespace ehl::program
