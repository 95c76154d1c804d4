#include "case/film_solution.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "case/effects.hpp"
#include "case/sliding_input.hpp"
#include "core/timer.hpp"
#include "steady/accuracy.hpp"
#include "steady/layer_error.hpp"
#include "steady/passes.hpp"
#include "steady/warnings.hpp"

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

// Shares of the progress: of the isothermal film in a film with heat, and of the starved film next to its flooded one.
constexpr double share_of_isothermal = 0.2, share_of_starved = 0.6;

steady::Solution flooded_with_heat(steady::Scene scene, const thermal::Setup& setup,
                                   const steady::ProgressCallback& progress) {
  scene.supply = {};
  scene.adjoint_errors = false;
  steady::Solution cold = steady::solve(scene, multigrid::part_of(progress, 0.0, share_of_isothermal));
  if (!cold.converged) return cold;
  return heat::solve(scene, setup, cold, multigrid::part_of(progress, share_of_isothermal, 1.0)).film;
}

void take_friction(const Case& input, const steady::Solution& film, HeatResult& result) {
  const friction::Friction friction = friction_of(input, film, &result.found.fields);
  result.mu = friction.sliding;
  result.error_mu = friction.error_sliding;
  result.unlikely = friction::unlikely(friction);
  result.friction_warnings = friction::warnings(friction);
}

// The remedy if no film with heat was found. in: friction of the isothermal film.
std::string advice_for_undone(const friction::Friction& isothermal) {
  if (isothermal.thinned || !friction::exceeds_any_oil(isothermal)) return "; use more cells, or less sliding";
  return fmt::format(
      "; a Newtonian oil would carry more than {:.2f} p on {:.0f} % of the load, as no oil does, and this "
      "heats it without bound: give [shear] law. More cells do not help, nor does [friction] limit alone",
      friction::largest_limit, 100.0 * isothermal.unlikely_share);
}

// Solves the isothermal film, then the film with heat or flow thinning; only the former if it does not converge.
FilmSolution solve_in_turn(const Case& input, const steady::Scene& scene, const steady::ProgressCallback& progress) {
  FilmSolution solution{.film = steady::solve(scene, multigrid::part_of(progress, 0.0, share_of_isothermal))};
  if (!solution.film.converged) return solution;
  const steady::Solution& before = solution.film;
  HeatResult result;
  result.Hc_isothermal = before.levels.back().Hc;
  result.Hm_isothermal = before.levels.back().Hm;
  const friction::Friction isothermal_friction = friction_of(input, before, nullptr);
  result.mu_isothermal = isothermal_friction.sliding;
  result.unlikely_isothermal = friction::unlikely(isothermal_friction);
  result.found = heat::solve(scene, setup_of(input), before, multigrid::part_of(progress, share_of_isothermal, 1.0));
  if (result.found.undone) result.found.film.failed_check += advice_for_undone(isothermal_friction);
  const std::optional<steady::Starvation> isothermal = before.starvation;
  solution.film = std::move(result.found.film);
  solution.film.starvation = isothermal;
  result.found.film = {};
  take_friction(input, solution.film, result);
  (input.heat ? solution.heat : solution.flow) = std::move(result);
  return solution;
}

// Contacts one after another on a track; the bodies enter each contact at their bulk temperature. The first and the
// last start from an isothermal film, the others from the hot film of the contact before.
FilmSolution solve_passes(const Case& input, const steady::Scene& scene, const steady::ProgressCallback& progress) {
  const double began = core::now();
  FilmSolution last;
  bool went_on = false;  // true if `last` already holds the solution of this pass
  const auto alone = [](steady::Scene one) {
    one.passes = {};
    return one;
  };
  // The passes on half as many cells only serve the error of the layer and are not kept.
  const auto shown = [&](const steady::Scene& one) { return one.grid.nx == scene.grid.nx; };
  const auto find = [&](const steady::Scene& one, const steady::ProgressCallback& part) {
    FilmSolution found = solve_in_turn(input, alone(one), part);
    steady::Solution film = found.film;
    if (shown(one) && (film.converged || !went_on)) last = std::move(found);
    return film;
  };
  const auto go_on = [&](const steady::Scene& one, const steady::Solution& before,
                         const steady::ProgressCallback& part) -> std::optional<steady::Solution> {
    HeatResult result{.mu_isothermal = NAN, .Hc_isothermal = NAN, .Hm_isothermal = NAN};
    result.found = heat::solve(alone(one), setup_of(input), before, part);
    steady::Solution film = std::move(result.found.film);
    if (!shown(one)) return film.converged ? std::optional(std::move(film)) : std::nullopt;
    went_on = film.converged;
    if (!went_on) return {};
    take_friction(input, film, result);
    last.heat = std::move(result);
    return film;
  };
  const double share = 1.0 / (scene.passes.number + 1.0);
  const steady::Solution flooded = flooded_with_heat(scene, setup_of(input), multigrid::part_of(progress, 0.0, share));
  last.film = steady::solve_passes(scene, steady::carried_at_centre(scene, flooded), find, go_on,
                                   multigrid::part_of(progress, share, 1.0));
  last.film.starvation = steady::starvation_of(scene, last.film, flooded);
  steady::add_errors_of_supply(last.film.passes, last.film.error_bars);
  last.film.warnings = steady::warnings_of(scene, last.film);
  last.film.seconds = core::now() - began;
  last.film.starvation->seconds = last.film.seconds - flooded.seconds - (last.heat ? last.heat->found.seconds : 0.0);
  return last;
}

FilmSolution solve_scene(const Case& input, const steady::Scene& scene, const steady::ProgressCallback& progress) {
  if (!(input.heat || input.flow_thinning)) return {.film = steady::solve(scene, progress)};
  if (!scene.supply) return solve_in_turn(input, scene, progress);
  if (scene.passes.number > 1) return solve_passes(input, scene, progress);
  FilmSolution solution = solve_in_turn(input, scene, multigrid::part_of(progress, 0.0, share_of_starved));
  const HeatResult* heat = solution.heat ? &*solution.heat : nullptr;
  if (heat == nullptr) return solution;
  const double seconds = solution.film.starvation->seconds + heat->found.seconds;
  solution.film.starvation = steady::starvation_of(
      scene, solution.film,
      flooded_with_heat(scene, setup_of(input), multigrid::part_of(progress, share_of_starved, 1.0)));
  solution.film.starvation->seconds = seconds;
  solution.film.warnings = steady::warnings_of(scene, solution.film);
  return solution;
}

}  // namespace

FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress) {
  if (!input.heat || std::isnan(input.scene.accuracy.error)) return solve_scene(input, input.scene, progress);
  FilmSolution last;
  const auto solve_on_grid = [&](const steady::Scene& one) {
    if (std::isnan(one.accuracy.error)) return steady::solve(one);  // a solution for the error of the domain
    steady::Scene alone = one;
    alone.accuracy = {};
    last = solve_scene(input, alone, progress);
    return last.film;
  };
  last.film = steady::solve_to_accuracy(input.scene, solve_on_grid, progress, false);
  return last;
}

// Only this function interprets the wording of `solution.method`; the rest of the program and the plots use the code.
std::string path_code(const steady::Solution& solution) {
  const std::string& method = solution.method;
  const std::string later = "full multigrid, start ";
  if (method.empty()) return "none";
  if (method.starts_with(later)) return "full-multigrid-" + method.substr(later.size());
  if (method.starts_with("load continuation")) return "load-continuation";
  if (method.starts_with("Newton-Krylov after")) return "newton-after-cycles";
  return method.starts_with("Newton") ? "newton" : "full-multigrid";
}

}  // namespace ehl::program
