#include "effects/subsurface/keys.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "deck/record.hpp"

namespace ehl::subsurface {
namespace {

std::vector<Quantity> all_quantities() {
  return {sigma_mises, tau_max, sigma_x, sigma_y, sigma_z, tau_xy, tau_xz, tau_yz};
}

std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (const Quantity one : all_quantities()) names.emplace_back(name(one));
  return names;
}

deck::Records<Parameters> records() {
  using namespace deck::record;
  return {
      key("depth", &Parameters::depth, Range{0.01, 1000.0}, example("2"),
          "Depth below the contact down to which the stresses are computed, in Hertz radii. Without this key there "
          "are no stresses. With [transient] they are computed at the stored times, and for the material of both "
          "bodies what it meets during the over-rolling.",
          remedy("in Hertz radii, e.g. 2")),
      key("planes", &Parameters::planes, Range{3, 1000}, own_default,
          "Number n of planes of constant depth, including the surface and the deepest plane. Plane k = 0..n-1 lies "
          "at (k/(n-1))^1.5 of the depth, so that planes are closer near the surface."),
      key("cells", &Parameters::most_cells, Range{16, 1048576}, own_default,
          "Largest number of cells along x of the grid for the stresses. It is the grid of the contact, halved as "
          "often as needed.",
          source("modules/effects/subsurface/README.md")),
      key("poisson", &Parameters::nu, Range{-1.0, 0.5, true, false}, example("0.3"),
          otherwise("nu1 of [contact], else 0.3"), "Poisson's ratio of the body whose stresses are computed."),
      key("friction", Range{-10.0, 10.0}, example("-0.05"),
          otherwise("with [friction]: the computed force on surface 1 over the load; else 0"),
          "Shear traction on the surface of the body over the pressure, positive along +x. The stresses are those of "
          "the pressure and of this traction. With [transient] it acts on body 1, and its opposite on body 2.",
          source("modules/effects/subsurface/README.md")),
      key("fields", deck::Type::words, by_default("sigma_mises, tau_max"), words(names_of_quantities()),
          "Stresses stored in space: sigma_mises is von Mises' equivalent stress, tau_max the largest shear stress, "
          "the others are the components. The section at y = 0 always has all of them. With [transient] these fields "
          "are those of the start.")};
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("subsurface", records()); }

Parameters read(deck::Deck& deck, double nu1, bool friction_is_computed) {
  const deck::Part subsurface{deck, "subsurface"};
  if (!friction_is_computed) subsurface.follow("friction", 0.0, "frictionless: there is no [friction]");
  const bool known = !std::isnan(nu1);
  subsurface.follow("poisson", known ? nu1 : Parameters{}.nu, known ? "nu1 of [contact]" : "value of steel");
  Parameters parameters = deck::read(subsurface, records());
  parameters.friction = subsurface.number("friction");
  const std::vector<std::string> fields = subsurface.words("fields");
  parameters.kept = all_quantities();
  std::erase_if(parameters.kept, [&](Quantity one) { return std::ranges::find(fields, name(one)) == fields.end(); });
  return parameters;
}

}  // namespace ehl::subsurface
