#include "rheology/shear_keys.hpp"

#include "deck/record.hpp"

namespace ehl::rheology {

std::vector<deck::Key> shear_keys() {
  using namespace deck::record;
  return deck::in_section(
      "shear",
      {key("law", words({"eyring", "carreau"}), example("eyring"),
           "Law of shear-thinning. eyring: tau = tau_0 asinh(eta rate/tau_0). carreau: tau = eta rate [1 + (eta "
           "rate/G)^2]^((n-1)/2). Without this key the oil is Newtonian. It acts only if the surfaces slide, or with "
           "flow = on.",
           source("Ehret, Dowson and Taylor 1998 for the film")),
       key("tau_0", unit("Pa"), up_to(1e15), needs("law", {"eyring"}), required("law = eyring needs it"),
           example("5e6"), "Eyring stress tau_0: shear stress at which thinning begins.",
           remedy("mineral oils have 2e6 to 1e7 Pa")),
       key("G", unit("Pa"), up_to(1e15), needs("law", {"carreau"}), required("law = carreau needs it"),
           example("6.9e6"), "Carreau stress G: shear stress at which thinning begins.",
           remedy("squalane has 6.9e6 Pa")),
       key("n", up_to(1.0), needs("law", {"carreau"}), required("law = carreau needs it"), example("0.46"),
           "Carreau exponent n: at high shear rates the shear stress grows with the rate to the power n.",
           remedy("squalane has 0.46; 1 is a Newtonian oil")),
       key("flow", by_default("off"), words({"off", "on"}), needs("law"),
           "on: the flow driven by the pressure gradient also thins the oil, with sliding or without it (srr = 0), and "
           "it obeys the limit of [friction]; the film is then computed by a fixed-point iteration. off: this flow is "
           "taken to first order, without the limit. In time on is not available with [thermal].")});
}

Shear read_shear(deck::Deck& deck) {
  const deck::Part shear{deck, "shear"};
  const bool eyring = shear.word("law") == "eyring";
  const double tau_0 = shear.number("tau_0"), G = shear.number("G"), n = shear.number("n");
  deck::check_required(shear);
  const bool flow = shear.word("flow") == "on";
  if (eyring) return {Eyring{}, tau_0, flow};
  return {Carreau{n}, G, flow};
}

}  // namespace ehl::rheology
