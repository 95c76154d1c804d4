#include "case/film_solution.hpp"

#include <cmath>
#include <utility>

#include "case/effects.hpp"
#include "case/sliding_input.hpp"
#include "steady/accuracy.hpp"

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

// Of the time of a film, isothermal and then with heat, that of the first. A starved film is solved flooded as well.
constexpr double share_of_isothermal = 0.2, share_of_starved = 0.6;

// What the film with heat is beside the flooded one with heat.
steady::Starvation starvation_of(const steady::Scene& scene, const heat::Solution& found, const thermal::Setup& setup,
                                 const steady::ProgressCallback& progress) {
  steady::Scene full = scene;
  full.supply = {};
  full.adjoint_errors = false;
  const steady::Solution cold = steady::solve(full, fmg::part_of(progress, 0.0, share_of_isothermal));
  if (!cold.converged) return steady::starvation_of(scene, found.film, cold, found.C);
  const heat::Solution warm = heat::solve(full, setup, cold, fmg::part_of(progress, share_of_isothermal, 1.0));
  return steady::starvation_of(scene, found.film, warm.film, found.C, warm.C);
}

FilmSolution solve_scene(const Case& input, const steady::Scene& scene, const steady::ProgressCallback& progress) {
  if (!(input.heat || input.flow_thinning)) return {.film = steady::solve(scene, progress)};
  const double whole = scene.supply ? share_of_starved : 1.0, isothermal = share_of_isothermal * whole;
  FilmSolution solution{.film = steady::solve(scene, fmg::part_of(progress, 0.0, isothermal))};
  if (!solution.film.converged) return solution;
  const steady::Solution& before = solution.film;
  HeatResult result;
  result.Hc_isothermal = before.levels.back().Hc;
  result.Hm_isothermal = before.levels.back().Hm;
  result.mu_isothermal = friction_of(input, before, nullptr).sliding;
  result.found = heat::solve(scene, setup_of(input), before, fmg::part_of(progress, isothermal, whole));
  if (scene.supply) {
    const double seconds = before.starvation->seconds;
    result.found.film.starvation =
        starvation_of(scene, result.found, setup_of(input), fmg::part_of(progress, whole, 1.0));
    result.found.film.starvation->seconds = seconds + result.found.seconds;
  }
  solution.film = std::move(result.found.film);
  result.found.film = {};
  result.mu = friction_of(input, solution.film, &result.found.fields).sliding;
  (input.heat ? solution.heat : solution.flow) = std::move(result);
  return solution;
}

}  // namespace

FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress) {
  if (!input.heat || std::isnan(input.scene.accuracy.error)) return solve_scene(input, input.scene, progress);
  FilmSolution last;
  const auto solve_on_grid = [&](const steady::Scene& one) {
    if (std::isnan(one.accuracy.error)) return steady::solve(one);  // for the error of the domain
    steady::Scene alone = one;
    alone.accuracy = {};
    last = solve_scene(input, alone, progress);
    return last.film;
  };
  last.film = steady::solve_to_accuracy(input.scene, solve_on_grid, progress, false);
  return last;
}

}  // namespace ehl::program
