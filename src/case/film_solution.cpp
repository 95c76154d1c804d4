#include "case/film_solution.hpp"

#include <utility>

#include "case/effects.hpp"

namespace ehl::program {

FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress) {
  FilmSolution solution{.film = steady::solve(input.scene, progress)};
  if (!input.heat || !solution.film.converged) return solution;
  const steady::Solution& cold = solution.film;
  HeatResult heat;
  heat.Hc_isothermal = cold.levels.back().Hc;
  heat.Hm_isothermal = cold.levels.back().Hm;
  heat.mu_isothermal = friction_of(input, cold, nullptr).sliding;
  heat.found = heat::solve(input.scene, input.heat->setup, cold, progress);
  solution.film = std::move(heat.found.film);
  heat.found.film = {};
  heat.mu = friction_of(input, solution.film, &heat.found.fields.I0).sliding;
  solution.heat = std::move(heat);
  return solution;
}

}  // namespace ehl::program
