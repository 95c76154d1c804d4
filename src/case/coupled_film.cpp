#include "case/coupled_film.hpp"

#include <utility>

#include "case/effects.hpp"
#include "core/constants.hpp"
#include "effects/heat/coupled.hpp"

namespace ehl::program {

std::optional<HeatResult> solve_coupled(const Case& input, const thermal::Setup& setup,
                                        const steady::ProgressCallback& progress, steady::Solution& film) {
  const Physics& physics = input.physics;
  const double eta0 = physics.si ? physics.si->contact.eta0 : core::unknown;
  heat::Coupled found = heat::solve_coupled({input.scene, setup, input.tuning.heat, physics.p_h, eta0}, progress);
  film = std::move(found.film);
  if (!found.heat) return std::nullopt;
  HeatResult result{.found = std::move(*found.heat)};
  const friction::Friction friction = friction_of(input, film, &result.found.fields);
  result.mu = friction.sliding;
  result.error_mu = friction.error_sliding;
  result.unlikely = friction::unlikely(friction);
  result.friction_warnings = friction::warnings(friction);
  if (!found.isothermal) return result;
  const friction::Friction isothermal = friction_of(input, *found.isothermal, nullptr);
  result.mu_isothermal = isothermal.sliding;
  result.unlikely_isothermal = friction::unlikely(isothermal);
  result.Hc_isothermal = found.isothermal->levels.back().Hc;
  result.Hm_isothermal = found.isothermal->levels.back().Hm;
  return result;
}

}  // namespace ehl::program
