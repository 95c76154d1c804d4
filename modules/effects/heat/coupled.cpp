#include "effects/heat/coupled.hpp"

#include <cmath>
#include <utility>

#include "core/timer.hpp"
#include "steady/accuracy.hpp"
#include "steady/layer_error.hpp"
#include "steady/passes.hpp"
#include "steady/warnings.hpp"

namespace ehl::heat {
namespace {

using multigrid::part_of;

// Shares of the progress: of the isothermal film in a film with heat, and of the starved film next to its flooded one.
constexpr double share_of_isothermal = 0.2, share_of_starved = 0.6;

steady::Solution flooded_with_heat(const Contact& contact, const steady::ProgressCallback& progress) {
  steady::Scene scene = contact.scene;
  scene.supply = {};
  scene.adjoint_errors = false;
  steady::Solution cold = steady::solve(scene, part_of(progress, 0.0, share_of_isothermal));
  if (!cold.converged) return cold;
  return solve(scene, contact.setup, contact.tuning, cold, part_of(progress, share_of_isothermal, 1.0)).film;
}

// Solves the isothermal film, then the film with heat or flow thinning; only the former if it does not converge.
Coupled solve_in_turn(const Contact& contact, const steady::Scene& scene, const steady::ProgressCallback& progress) {
  Coupled found{.film = steady::solve(scene, part_of(progress, 0.0, share_of_isothermal))};
  if (!found.film.converged) return found;
  Solution& heat = found.heat.emplace(
      solve(scene, contact.setup, contact.tuning, found.film, part_of(progress, share_of_isothermal, 1.0)));
  heat.film.starvation = found.film.starvation;
  found.isothermal = std::exchange(found.film, std::exchange(heat.film, {}));
  return found;
}

// The first and the last pass start from an isothermal film, the others from the hot film of the pass before.
Coupled solve_passes(const Contact& contact, const steady::ProgressCallback& progress) {
  const steady::Scene& scene = contact.scene;
  const double began = core::now();
  Coupled last;
  bool went_on = false;  // true if `last` already holds the solution of this pass
  const auto alone = [](steady::Scene one) {
    one.passes = {};
    return one;
  };
  // The passes on half as many cells only serve the error of the layer and are not kept.
  const auto shown = [&](const steady::Scene& one) { return one.grid.nx == scene.grid.nx; };
  const auto find = [&](const steady::Scene& one, const steady::ProgressCallback& part) {
    Coupled found = solve_in_turn(contact, alone(one), part);
    steady::Solution film = found.film;
    if (shown(one) && (film.converged || !went_on)) last = std::move(found);
    return film;
  };
  const auto go_on = [&](const steady::Scene& one, const steady::Solution& before,
                         const steady::ProgressCallback& part) -> std::optional<steady::Solution> {
    Solution heat = solve(alone(one), contact.setup, contact.tuning, before, part);
    steady::Solution film = std::exchange(heat.film, {});
    if (!shown(one)) return film.converged ? std::optional(std::move(film)) : std::nullopt;
    went_on = film.converged;
    if (!went_on) return {};
    last = {.heat = std::move(heat)};
    return film;
  };
  const double share = 1.0 / (scene.passes.number + 1.0);
  const steady::Solution flooded = flooded_with_heat(contact, part_of(progress, 0.0, share));
  last.film = steady::solve_passes(scene, steady::carried_at_centre(scene, flooded), find, go_on,
                                   part_of(progress, share, 1.0));
  last.film.starvation = steady::starvation_of(scene, last.film, flooded);
  steady::add_errors_of_supply(scene.tuning, last.film.passes, last.film.error_bars);
  last.film.warnings = steady::warnings_of(scene, last.film);
  last.film.seconds = core::now() - began;
  last.film.starvation->seconds = last.film.seconds - flooded.seconds - (last.heat ? last.heat->seconds : 0.0);
  return last;
}

Coupled solve_on_grid(const Contact& contact, const steady::ProgressCallback& progress) {
  const steady::Scene& scene = contact.scene;
  if (!scene.supply) return solve_in_turn(contact, scene, progress);
  if (scene.passes.number > 1) return solve_passes(contact, progress);
  Coupled found = solve_in_turn(contact, scene, part_of(progress, 0.0, share_of_starved));
  if (!found.heat) return found;
  const double seconds = found.film.starvation->seconds + found.heat->seconds;
  found.film.starvation =
      steady::starvation_of(scene, found.film, flooded_with_heat(contact, part_of(progress, share_of_starved, 1.0)));
  found.film.starvation->seconds = seconds;
  found.film.warnings = steady::warnings_of(scene, found.film);
  return found;
}

}  // namespace

Coupled solve_coupled(const Contact& contact, const steady::ProgressCallback& progress) {
  if (std::isnan(contact.scene.accuracy.error)) return solve_on_grid(contact, progress);
  Coupled last;
  const auto find = [&](const steady::Scene& one) {
    if (std::isnan(one.accuracy.error)) return steady::solve(one);  // a solution for the error of the domain
    steady::Scene alone = one;
    alone.accuracy = {};
    last = solve_on_grid({alone, contact.setup, contact.tuning}, progress);
    return last.film;
  };
  last.film = steady::solve_to_accuracy(contact.scene, find, progress, false);
  return last;
}

}  // namespace ehl::heat
