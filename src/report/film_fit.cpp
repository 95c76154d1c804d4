#include "report/film_fit.hpp"

#include <fmt/core.h>

#include <cmath>

#include "case/numbers/number.hpp"
#include "contact/film_map.hpp"
#include "report/report.hpp"
#include "rheology/laws.hpp"

namespace ehl::program {
namespace {

/// Largest relative difference of the densities at the Hertz pressure for which the accuracy of the fit is claimed.
/// Most contacts of tests/reference/film_map_oils.csv stay below it. [bench: other_density]
constexpr double other_density = 0.05;

double density_at(const rheology::DensityLaw& law, double P) {
  double rho_bar = 0.0;
  rheology::density(law, {&P, 1}, {&rho_bar, 1});
  return rho_bar;
}

// Density at the Hertz pressure, relative to that of the oil of the fit at the same M and L*, minus 1.
double density_difference(const Physics& physics, double L_star) {
  const contact::Groups& groups = physics.groups;
  const double alpha_bar_star = groups.L > 0.0 ? groups.alpha_bar * L_star / groups.L : 0.0;
  const double p_h = alpha_bar_star / contact::alpha_star_of_film_map();
  const double of_fit = p_h > 0.0 ? density_at(rheology::make_dowson_higginson(p_h), 1.0) : 1.0;
  return density_at(physics.density, 1.0) / of_fit - 1.0;
}

}  // namespace

std::optional<Formula> fitted_film(const Physics& physics) {
  const contact::Groups& groups = physics.groups;
  const auto map = contact::film_map(groups.M, film_coefficients(physics).L_star, groups.shape);
  if (!map) return std::nullopt;
  return Formula{"fit to our own solutions", map_code, contact::H_from_moes_units(map->central, groups.M, groups.shape),
                 contact::H_from_moes_units(map->minimum, groups.M, groups.shape)};
}

std::string fitted_film_line(const Physics& physics) {
  const contact::Ellipse& shape = physics.groups.shape;
  if (contact::line(shape) || contact::roller(shape) || contact::gap(shape).oblique()) return {};
  const double L_star = film_coefficients(physics).L_star;
  if (std::isnan(L_star)) return {};
  if (!contact::film_map(physics.groups.M, L_star, shape))
    return fmt::format("  fit to our own solutions: this contact, with L* = {:.4g}, is outside the fitted range, {}\n",
                       L_star, contact::range_of_film_map());
  if (const double difference = density_difference(physics, L_star); std::isnan(difference))
    return {};
  else if (std::abs(difference) > other_density)
    return fmt::format(
        "  the accuracy of the fit is not known here: at p_h this oil is {:.0f} % {} than the oil of the fit\n",
        100.0 * std::abs(difference), difference > 0.0 ? "denser" : "less dense");
  const bool isoviscous = L_star == 0.0;
  const contact::MapScatter off = isoviscous ? contact::scatter_of_film_map() : contact::scatter_of_other_oils();
  return fmt::format(
      "  the error of the fit, with alpha*, is {:.1f} % in {} and {:.1f} % in {} (root mean square; at most {:.0f} "
      "and {:.0f} %) for solutions{} not used in the fit\n",
      100.0 * off.rms_central, numbers::symbol_of(id::hc), 100.0 * off.rms_minimum, numbers::symbol_of(id::hm),
      std::ceil(100.0 * off.largest_central), std::ceil(100.0 * off.largest_minimum), isoviscous ? "" : " with oils");
}

}  // namespace ehl::program
