#include "effects/subsurface/keys.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "deck/text.hpp"

namespace ehl::subsurface {
namespace {

using deck::Type;

std::vector<Quantity> all_quantities() {
  return {sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz};
}

std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (const Quantity one : all_quantities()) names.emplace_back(name(one));
  return names;
}

}  // namespace

std::vector<deck::Key> keys() {
  const Parameters defaults;
  return deck::in_section(
      "subsurface",
      {{.name = "depth",
        .range = {0.01, 1000.0},
        .remedy = "in Hertz radii, e.g. 2",
        .meaning = "Depth below the contact down to which the stresses are computed, in Hertz radii. Without this key "
                   "there are no stresses.",
        .example = "2"},
       {.name = "planes",
        .type = Type::integer,
        .default_text = std::to_string(defaults.planes),
        .range = {3, 1000},
        .meaning = "Number n of planes of constant depth, including the surface and the deepest plane. Plane k = "
                   "0..n-1 lies at (k/(n-1))^1.5 of the depth, so that planes are closer near the surface."},
       {.name = "cells",
        .type = Type::integer,
        .default_text = std::to_string(defaults.most_cells),
        .range = {16, 1048576},
        .meaning = "Largest number of cells along x of the grid for the stresses. It is the grid of the contact, "
                   "halved as often as needed.",
        .source = "modules/effects/subsurface/README.md"},
       {.name = "poisson",
        .default_note = "nu1 of [contact], else 0.3",
        .range = {-1.0, 0.5, true, false},
        .meaning = "Poisson's ratio of the body whose stresses are computed.",
        .example = "0.3"},
       {.name = "friction",
        .default_note = "with [friction]: the computed force on surface 1 over the load; else 0",
        .range = {-10.0, 10.0},
        .meaning = "Shear traction on the surface of the body over the pressure, positive along +x. The stresses are "
                   "those of the pressure and of this traction.",
        .source = "modules/effects/subsurface/README.md",
        .example = "-0.05"},
       {.name = "fields",
        .type = Type::words,
        .default_text = "sigma_mises, tau_max",
        .words = names_of_quantities(),
        .meaning = "Stresses stored in space: sigma_mises is von Mises' equivalent stress, tau_max the largest shear "
                   "stress, the others are the components. The section at y = 0 always has all of them."}});
}

Parameters read(deck::Deck& deck, double nu1, bool friction_is_computed) {
  const deck::Part subsurface{deck, "subsurface"};
  Parameters parameters;
  parameters.depth = subsurface.number("depth");
  parameters.planes = subsurface.integer("planes", parameters.planes);
  parameters.most_cells = subsurface.integer("cells", parameters.most_cells);
  if (!friction_is_computed) subsurface.follow("friction", 0.0, "frictionless: there is no [friction]");
  parameters.friction = subsurface.number("friction");
  const bool known = !std::isnan(nu1);
  subsurface.follow("poisson", known ? nu1 : parameters.nu, known ? "nu1 of [contact]" : "value of steel");
  parameters.nu = subsurface.number("poisson");
  const std::vector<std::string> fields = subsurface.words("fields");
  parameters.kept = all_quantities();
  std::erase_if(parameters.kept, [&](Quantity one) { return std::ranges::find(fields, name(one)) == fields.end(); });
  return parameters;
}

}  // namespace ehl::subsurface
