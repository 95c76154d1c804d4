#include "case/coupled_film.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "case/effects.hpp"
#include "effects/heat/coupled.hpp"

namespace ehl::program {
namespace {

// The remedy if no film with heat was found. in: friction of the isothermal film.
std::string advice_for_undone(const friction::Friction& isothermal) {
  if (isothermal.thinned || !friction::exceeds_any_oil(isothermal)) return "; use more cells, or less sliding";
  return fmt::format(
      "; a Newtonian oil would carry more than {:.2f} p on {:.0f} % of the load, as no oil does, and this "
      "heats it without bound: give [shear] law. More cells do not help, nor does [friction] limit alone",
      friction::largest_limit, 100.0 * isothermal.unlikely_share);
}

}  // namespace

std::optional<HeatResult> solve_coupled(const Case& input, const thermal::Setup& setup,
                                        const steady::ProgressCallback& progress, steady::Solution& film) {
  heat::Coupled found = heat::solve_coupled({input.scene, setup, input.tuning.heat}, progress);
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
  if (result.found.undone) film.failed_check += advice_for_undone(isothermal);
  result.mu_isothermal = isothermal.sliding;
  result.unlikely_isothermal = friction::unlikely(isothermal);
  result.Hc_isothermal = found.isothermal->levels.back().Hc;
  result.Hm_isothermal = found.isothermal->levels.back().Hm;
  return result;
}

}  // namespace ehl::program
