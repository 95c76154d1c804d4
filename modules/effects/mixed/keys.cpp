#include "effects/mixed/keys.hpp"

#include <cmath>

#include "deck/record.hpp"

namespace ehl::mixed {
namespace {

deck::Records<Input> records() {
  using namespace deck::record;
  const auto adsorbed = remedy("adsorbed layers are 1 to 10 nm thick");
  return {
      key("h_b", unit("m"), up_to(1e-6), example("2e-9"),
          "Thickness of the boundary film that remains between surfaces that touch, for a contact in SI: the adsorbed "
          "layer. The gap is nowhere thinner; where it is this thin the surfaces carry load by a contact pressure in "
          "addition to that of the oil. With this key asperity contact is part of a steady point, elliptic or line "
          "contact. Not available with [transient], [thermal], [supply], [shear] flow = on, rollers, or [grid] "
          "accuracy.",
          adsorbed, source("modules/effects/mixed/README.md")),
      key("H_b", &Input::H_b, positive, instead_of({"h_b"}), example("0.01"),
          "The same in units of H: h_b R/a^2. For a contact in M and L.", source("modules/effects/mixed/README.md")),
      key("mu_b", &Input::mu_b, Range{0.0, 2.0}, example("0.12"),
          "Friction coefficient of the boundary film where the surfaces touch. [friction] then has a boundary part, "
          "mu_b times the load share of the contact.",
          remedy("boundary films have 0.08 to 0.15")),
      key("hardness", unit("Pa"), positive, example("8e9"), otherwise("none: the bodies stay elastic"),
          "Hardness of the softer surface: largest contact pressure. Where it is reached, the surface yields by as "
          "much as "
          "keeps the gap at the boundary film.",
          remedy("hardened steel has 6e9 to 8e9"))};
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("mixed", records()); }

bool called_for(const deck::Deck& deck) {
  return deck::given(deck, "mixed", "h_b") || deck::given(deck, "mixed", "H_b");
}

Input read(deck::Deck& deck, const Scales& scales) {
  const deck::Part mixed{deck, "mixed"};
  Input input = deck::read(mixed, records());
  if (std::isnan(scales.height))
    mixed.refuse({"h_b"}, "is in SI, but the contact is not: give H_b, in units of H");
  else if (mixed.given("h_b"))
    input.H_b = mixed.number("h_b") / scales.height;
  if (!mixed.given("hardness")) return input;
  if (std::isnan(scales.p_h))
    mixed.refuse({"hardness"}, "is in SI, but the Hertz pressure of this contact is not known: give the contact in SI");
  else
    input.hardness = mixed.number("hardness") / scales.p_h;
  return input;
}

}  // namespace ehl::mixed
