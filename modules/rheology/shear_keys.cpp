#include "rheology/shear_keys.hpp"

namespace ehl::rheology {

std::vector<deck::Key> shear_keys() {
  constexpr deck::Range stress{0.0, 1e15, true, false};
  return deck::in_section(
      "shear",
      {{.name = "law",
        .words = {"eyring", "carreau"},
        .meaning = "Law of shear-thinning. eyring: tau = tau_0 asinh(eta rate/tau_0). carreau: tau = eta rate [1 + "
                   "(eta rate/G)^2]^((n-1)/2). Without this key the oil is Newtonian. It acts only if the surfaces "
                   "slide, or with flow = on.",
        .source = "Ehret, Dowson and Taylor 1998 for the film",
        .example = "eyring"},
       {.name = "tau_0",
        .unit = "Pa",
        .range = stress,
        .remedy = "mineral oils have 2e6 to 1e7 Pa",
        .meaning = "Eyring stress tau_0: shear stress at which thinning begins.",
        .needs = {.name = "law", .words = {"eyring"}},
        .example = "5e6"},
       {.name = "G",
        .unit = "Pa",
        .range = stress,
        .remedy = "squalane has 6.9e6 Pa",
        .meaning = "Carreau stress G: shear stress at which thinning begins.",
        .needs = {.name = "law", .words = {"carreau"}},
        .example = "6.9e6"},
       {.name = "n",
        .range = {0.0, 1.0, true, false},
        .remedy = "squalane has 0.46; 1 is a Newtonian oil",
        .meaning = "Carreau exponent n: at high shear rates the shear stress grows with the rate to the power n.",
        .needs = {.name = "law", .words = {"carreau"}},
        .example = "0.46"},
       {.name = "flow",
        .default_text = "off",
        .words = {"off", "on"},
        .meaning = "on: the flow driven by the pressure gradient also thins the oil, with sliding or without it (srr = "
                   "0), and it obeys the limit of [friction]; the film is then computed by a fixed-point iteration. "
                   "off: this flow is taken to first order, without the limit.",
        .needs = {.name = "law", .words = {}}}});
}

Shear read_shear(deck::Deck& deck) {
  const deck::Part shear{deck, "shear"};
  const bool eyring = shear.word("law") == "eyring";
  const double tau_0 = shear.number("tau_0"), G = shear.number("G"), n = shear.number("n");
  shear.demand(eyring ? std::vector<std::string>{"tau_0"} : std::vector<std::string>{"G", "n"},
               std::string("law = ") + (eyring ? "eyring" : "carreau") + " needs it");
  const bool flow = shear.word("flow") == "on";
  if (eyring) return {Eyring{}, tau_0, flow};
  return {Carreau{n}, G, flow};
}

}  // namespace ehl::rheology
