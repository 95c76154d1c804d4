#include "report/outcome.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "case/plausible.hpp"
#include "case/published.hpp"
#include "contact/film_formulas.hpp"
#include "contact/yield.hpp"
#include "core/constants.hpp"
#include "core/norms.hpp"
#include "report/film_fit.hpp"
#include "report/moving_surfaces.hpp"
#include "report/roughness.hpp"
#include "rheology/range.hpp"

namespace ehl::program {
namespace {

using core::unknown;

Place place(const core::Grid& grid, const core::Location& location) {
  return {location.value, grid.X(location.i), grid.Y(location.j)};
}

// The warnings of the solution, and those that need the scales of the physical contact.
core::Warnings warnings_of(const Physics& physics, const steady::Solution& solution, double P_max) {
  core::Warnings warnings = solution.warnings;
  const double eta0 = physics.si ? physics.si->contact.eta0 : unknown;
  for (core::Warning& warning :
       rheology::out_of_range(physics.viscosity, physics.density, {.P_max = P_max, .p_h = physics.p_h, .eta0 = eta0}))
    warnings.push_back(std::move(warning));
  if (physics.groups.L == 0.0 && !std::holds_alternative<rheology::Isoviscous>(physics.viscosity))
    warnings.push_back({"no-load",
                        "L = 0 is the limit without pressures that would change the lubricant: solved as isoviscous "
                        "and incompressible"});
  if (std::optional<core::Warning> warning = contact::beyond_yield(physics.p_h)) warnings.push_back(*warning);
  return warnings;
}

std::vector<Formula> published_formulas(const contact::Groups& groups) {
  const contact::Ellipse& shape = groups.shape;
  const bool fitted = contact::along_smaller_radius(shape);
  const double M = groups.M;
  std::vector<Formula> formulas;
  const bool line = contact::line(shape);
  if (line)
    formulas.push_back({published::moes.name, published::moes.code,
                        contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, groups.L, shape), M, shape),
                        unknown});
  else if (fitted)
    formulas.push_back({published::nvm.name, published::nvm.code,
                        contact::H_from_moes_units(contact::nijenbanning_venner_moes(M, groups.L, shape), M, shape),
                        unknown});
  if (!(groups.L > 0.0)) return formulas;
  const bool assumed = std::isnan(groups.U);
  const contact::Groups full = contact::with_typical_U(groups);
  const auto add = [&](const Publication& by, const contact::FilmThickness& film) {
    formulas.push_back({std::string(by.name) + (assumed ? " (U = 1e-11)" : ""), by.code,
                        contact::H_from_thickness_over_radius(film.central, full.W, shape),
                        contact::H_from_thickness_over_radius(film.minimum, full.W, shape)});
  };
  if (line) {
    add(published::dh, contact::dowson_higginson(full));
    return formulas;
  }
  if (fitted) add(published::hd, contact::hamrock_dowson(full));
  if (!contact::circular(shape) && contact::near_chittenden(shape))
    add(published::chittenden, contact::chittenden(full));
  return formulas;
}

}  // namespace

std::vector<Formula> film_formulas(const Physics& physics) {
  std::vector<Formula> formulas = published_formulas(physics.groups);
  if (std::optional<Formula> fit = fitted_film(physics)) formulas.push_back(std::move(*fit));
  return formulas;
}

std::string formulas_left_out(const contact::Groups& groups) {
  if (contact::along_smaller_radius(groups.shape)) return {};
  const std::string fitted =
      "Nijenbanning, Venner, Moes and Hamrock, Dowson are omitted: they were fitted for rolling along the smaller "
      "radius";
  if (contact::near_chittenden(groups.shape)) return fitted;
  return fitted + "; Chittenden et al. differ from our solutions by up to half of the film";
}

Outcome outcome_of(const Case& input, const steady::Solution& solution) {
  const contact::Groups& groups = input.physics.groups;
  const double h_scale = input.physics.si ? input.physics.si->hertz.h_scale : unknown;
  Outcome outcome;
  outcome.Hc = solution.levels.empty() ? unknown : solution.levels.back().Hc;
  outcome.Hm = place(solution.grid, core::minimum(solution.H));
  outcome.P_max = place(solution.grid, core::maximum(solution.P));
  outcome.Hc_moes = contact::H_to_moes_units(outcome.Hc, groups.M, groups.shape);
  outcome.Hm_moes = contact::H_to_moes_units(outcome.Hm.value, groups.M, groups.shape);
  outcome.hc = outcome.Hc * h_scale;
  outcome.hm = outcome.Hm.value * h_scale;
  outcome.formulas = film_formulas(input.physics);
  outcome.regime = contact::regime_text(groups.M, groups.L, groups.shape);
  outcome.warnings = warnings_of(input.physics, solution, outcome.P_max.value);
  for (core::Warning& warning : surface_warnings(input.surfaces, solution.grid)) outcome.warnings.push_back(warning);
  outcome.roughness = roughness_of(input, outcome.formulas, outcome.Hm.value);
  if (std::optional<core::Warning> warning = roughness_warning(input, outcome.roughness))
    outcome.warnings.push_back(*warning);
  if (std::optional<core::Warning> warning = tuning_warning(input.tuning)) outcome.warnings.push_back(*warning);
  for (core::Warning& warning : hardly_meant(input)) outcome.warnings.push_back(std::move(warning));
  for (core::Warning& warning : hardly_a_film(outcome.hc, outcome.hm)) outcome.warnings.push_back(std::move(warning));
  for (core::Warning& warning : moving_surface_warnings(input)) outcome.warnings.push_back(std::move(warning));
  return outcome;
}

bool has_film(const steady::Solution& solution) { return !solution.levels.empty() && solution.H.nodes_x() > 0; }

bool is_finite(const Outcome& outcome) { return std::isfinite(outcome.Hc + outcome.Hm.value + outcome.P_max.value); }

const char* name(reynolds::Wedge wedge) {
  switch (wedge) {
    case reynolds::Wedge::upstream1: return "upstream1";
    case reynolds::Wedge::upstream2: return "upstream2";
    case reynolds::Wedge::upstream3: return "upstream3";
    default: return "upstream3_inlet";
  }
}

const char* name(reynolds::Face face) {
  switch (face) {
    case reynolds::Face::mean: return "mean";
    case reynolds::Face::logmean: return "logmean";
    default: return "logmean_bounded";
  }
}

const char* name(mlmi::Method method) {
  switch (method) {
    case mlmi::Method::mlmi: return "mlmi";
    case mlmi::Method::fft: return "fft";
    case mlmi::Method::direct: break;
  }
  return "direct";
}

}  // namespace ehl::program
