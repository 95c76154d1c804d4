#include "effects/subsurface/keys.hpp"

#include <string>

#include "deck/text.hpp"
#include "effects/subsurface/stress.hpp"

namespace ehl::subsurface {
namespace {

using deck::Key;
using deck::Type;

std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (int k = 0; k < quantities; ++k) names.emplace_back(name(static_cast<Quantity>(k)));
  return names;
}

}  // namespace

std::vector<Key> keys() {
  const Parameters defaults;
  return {
      Key{.section = "subsurface",
          .name = "depth",
          .range = {0.01, 1000.0},
          .remedy = "in Hertz radii, e.g. 2",
          .meaning =
              "Depth of the lowest plane in Hertz radii: how far below the contact the stresses are computed. Without "
              "it they are not.",
          .example = "2"},
      Key{.section = "subsurface",
          .name = "planes",
          .type = Type::integer,
          .default_text = std::to_string(defaults.planes),
          .range = {3, 1000},
          .meaning =
              "Planes of constant depth, surface and lowest included: number k = 0..n-1 lies at depth (k/(n-1))^1.5, "
              "closer to its neighbours near the surface."},
      Key{.section = "subsurface",
          .name = "cells",
          .type = Type::integer,
          .default_text = std::to_string(defaults.most_cells),
          .range = {16, 1048576},
          .meaning =
              "The stresses' grid has at most so many cells along x: the contact's grid, halved as often as needed.",
          .source = "modules/effects/subsurface/README.md"},
      Key{.section = "subsurface",
          .name = "poisson",
          .default_note = "nu1 of [contact], or 0.3",
          .range = {-1.0, 0.5, true, false},
          .meaning = "Poisson's ratio of the body whose stresses are computed.",
          .example = "0.3"},
      Key{.section = "subsurface",
          .name = "friction",
          .default_text = deck::shortest(defaults.friction),
          .range = {-10.0, 10.0},
          .meaning =
              "Shear traction on the surface of the body over the pressure, positive along +x: stresses belong to "
              "pressure and this traction."},
      Key{.section = "subsurface",
          .name = "fields",
          .type = Type::words,
          .default_text = "sigma_mises, tau_max",
          .words = names_of_quantities(),
          .meaning =
              "The stresses to keep in space: von Mises' equivalent stress, the largest shear stress, the components. "
              "The section at y = 0 has them all."},
  };
}

}  // namespace ehl::subsurface
