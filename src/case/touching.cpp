#include "case/touching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text_format.hpp"
#include "contact/film_formulas.hpp"
#include "contact/film_map.hpp"
#include "core/constants.hpp"
#include "surface/resample.hpp"

namespace ehl::program {
namespace {

// The minimum film of a formula, in a^2/R.
double over_radius(const contact::FilmThickness& film, const contact::Groups& groups) {
  return contact::H_from_thickness_over_radius(film.minimum, groups.W, groups.shape);
}

// The part of the roughness that the mesh resolves: waves shorter than a cell are averaged out.
double roughness_on_mesh(const Case& input) {
  double Sq = input.roller ? input.roller->trace.rough : 0.0;
  for (const CarriedSurface* one : carried(input.surfaces))
    if (one->map) {
      const double lost =
          surface::resolution(std::get<surface::HeightMap>(one->relief), input.scene.grid).variance_lost;
      Sq = std::hypot(Sq, one->map->rms * std::sqrt(1.0 - std::min(1.0, lost)));
    }
  return Sq;
}

}  // namespace

std::string height_text(const Case& input, double H) {
  return input.physics.si ? length(H * input.physics.si->hertz.h_scale) : fmt::format("{:.4g} a^2/R", H);
}

double measured_roughness(const Case& input) {
  double Sq = input.roller ? input.roller->trace.rough : 0.0;
  for (const CarriedSurface* one : carried(input.surfaces))
    if (one->map) Sq = std::hypot(Sq, one->map->rms);
  return Sq;
}

double smallest_smooth_film(const contact::Groups& groups) {
  const contact::Ellipse& shape = groups.shape;
  if (const auto fit = contact::film_map(groups.M, groups.L, shape))
    return contact::H_from_moes_units(fit->minimum, groups.M, shape);
  if (!(groups.L > 0.0)) return core::unknown;
  const contact::Groups full = contact::with_typical_U(groups);
  if (contact::line(shape)) return over_radius(contact::dowson_higginson(full), full);
  if (contact::along_smaller_radius(shape)) return over_radius(contact::hamrock_dowson(full), full);
  if (contact::near_chittenden(shape)) return over_radius(contact::chittenden(full), full);
  return core::unknown;
}

std::string why_they_touch(const Case& input) {
  if (input.transient || !(input.scene.contact.M > 0.0)) return {};
  const double film = smallest_smooth_film(input.physics.groups);
  if (!(measured_roughness(input) > film)) return {};
  const double Sq = roughness_on_mesh(input);
  if (!(Sq > film)) return {};
  return fmt::format(
      "the surfaces touch: the measured roughness Sq = {} exceeds the minimum film of smooth surfaces, {} (lambda "
      "ratio {:.2g}), and asperity contact is not computed{}; remove short waves with {}, or use a smooth {}. Only the "
      "first strategy was tried; [continuation] path = load tries more",
      height_text(input, Sq), height_text(input, film), film / Sq, input.roller ? "" : " without [mixed]",
      input.roller && input.roller->trace.rough > 0.0 ? "[roller] shortest_wave" : "shortest_wave of the map",
      input.roller ? "profile" : "surface");
}

}  // namespace ehl::program
