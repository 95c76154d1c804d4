#include "outcome.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contact/film_formulas.hpp"
#include "contact/yield.hpp"
#include "core/norms.hpp"
#include "rheology/range.hpp"

namespace ehl::program {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Place place(const core::Grid& grid, const core::Location& location) {
  return {location.value, grid.X(location.i), grid.Y(location.j)};
}

// The solution's own, and those that need the scales of the physical contact.
std::vector<std::string> warnings_of(const Physics& physics, const steady::Solution& solution, double P_max) {
  std::vector<std::string> warnings = solution.warnings;
  const double eta0 = physics.si ? physics.si->contact.eta0 : unknown;
  for (std::string& warning :
       rheology::out_of_range(physics.viscosity, physics.density, {.P_max = P_max, .p_h = physics.p_h, .eta0 = eta0}))
    warnings.push_back(std::move(warning));
  if (physics.groups.L == 0.0 && !std::holds_alternative<rheology::Isoviscous>(physics.viscosity))
    warnings.push_back(
        "L = 0 is the limit in which no pressure arises that would change the lubricant: solved as isoviscous and "
        "incompressible");
  if (std::optional<std::string> warning = contact::beyond_yield(physics.p_h)) warnings.push_back(*warning);
  return warnings;
}

}  // namespace

std::vector<Formula> film_formulas(const contact::Groups& groups) {
  const double M = groups.M;
  std::vector<Formula> formulas{{"Nijenbanning, Venner, Moes 1994",
                                 contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, groups.L), M),
                                 unknown}};
  if (groups.L > 0.0) {
    // In Moes' units the formula hardly depends on U (h_c to the power of -0.013, h_m 0.003), so that a typical U
    // serves where the deck gives M and L alone.
    constexpr double typical_U = 1e-11;
    const bool assumed = std::isnan(groups.U);
    const contact::Groups full = assumed ? contact::from_moes(M, groups.L, typical_U) : groups;
    const contact::FilmThickness film = contact::hamrock_dowson(full);
    formulas.push_back({assumed ? "Hamrock, Dowson 1977 (U = 1e-11)" : "Hamrock, Dowson 1977",
                        contact::H_from_thickness_over_radius(film.central, full.W),
                        contact::H_from_thickness_over_radius(film.minimum, full.W)});
  }
  return formulas;
}

Outcome outcome_of(const Case& input, const steady::Solution& solution) {
  const contact::Groups& groups = input.physics.groups;
  const double h_scale = input.physics.si ? input.physics.si->hertz.h_scale : unknown;
  Outcome outcome;
  outcome.Hc = solution.levels.empty() ? unknown : solution.levels.back().Hc;
  outcome.Hm = place(solution.grid, core::minimum(solution.H));
  outcome.P_max = place(solution.grid, core::maximum(solution.P));
  outcome.Hc_moes = contact::H_to_moes_units(outcome.Hc, groups.M);
  outcome.Hm_moes = contact::H_to_moes_units(outcome.Hm.value, groups.M);
  outcome.hc = outcome.Hc * h_scale;
  outcome.hm = outcome.Hm.value * h_scale;
  outcome.formulas = film_formulas(groups);
  outcome.regime = contact::regime_text(groups.M, groups.L);
  outcome.warnings = warnings_of(input.physics, solution, outcome.P_max.value);
  for (std::string& warning : surface_warnings(input.surfaces, solution.grid)) outcome.warnings.push_back(warning);
  return outcome;
}

const char* name(reynolds::Wedge wedge) { return wedge == reynolds::Wedge::upstream1 ? "upstream1" : "upstream2"; }

const char* name(mlmi::Method method) {
  switch (method) {
    case mlmi::Method::mlmi: return "mlmi";
    case mlmi::Method::fft: return "fft";
    case mlmi::Method::direct: break;
  }
  return "direct";
}

}  // namespace ehl::program
