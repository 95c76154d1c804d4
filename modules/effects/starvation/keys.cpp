#include "effects/starvation/keys.hpp"

namespace ehl::starvation {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<deck::Key> keys() {
  return deck::in_section(
      "supply",
      {{.name = "H_oil",
        .range = {0.0, none, true, true},
        .remedy = "without oil there is no film: [case] kind = dry",
        .meaning = "What both surfaces bring of oil, in units of H: R (u1 h1 + u2 h2)/(u_m a^2). The flooded film and "
                   "more: hardly starved; a tenth of it: the layer goes through as it is.",
        .source = "modules/effects/starvation/README.md",
        .example = "0.2"},
       {.name = "layer_m",
        .unit = "m",
        .range = {0.0, none, true, true},
        .remedy = "without oil there is no film: [case] kind = dry",
        .meaning = "Layer of oil on both surfaces together, for a contact in SI.",
        .example = "200e-9"},
       {.name = "layer1_m",
        .unit = "m",
        .range = {0.0, none, false, true},
        .meaning = "Layer on surface 1 alone, brought with its own speed u1 (layer1_m and layer2_m, or layer_m).",
        .example = "100e-9"},
       {.name = "layer2_m",
        .unit = "m",
        .range = {0.0, none, false, true},
        .meaning = "Layer on surface 2.",
        .example = "100e-9"},
       {.name = "flow_m3_per_s",
        .unit = "m^3/s",
        .range = {0.0, none, true, true},
        .remedy = "without oil there is no film: [case] kind = dry",
        .meaning = "Oil that is brought to the inlet, spread evenly over the width of the domain.",
        .example = "1e-10"},
       {.name = "profile",
        .type = deck::Type::text,
        .meaning = "Layer across the track: a CSV with columns y and h, of both surfaces together, in metres; of a "
                   "contact in M and L in units of X and H. It covers the width of the domain.",
        .example = "track.csv",
        .names_file = true}});
}

bool called_for(const deck::Deck& deck) {
  for (const deck::Key& key : keys())
    if (deck::given(deck, "supply", key.name)) return true;
  return false;
}

Input read(deck::Deck& deck, const Scales& scales) {
  const deck::Part supply{deck, "supply"};
  Input input;
  const bool two = supply.given("layer1_m") || supply.given("layer2_m");
  std::vector<std::string> ways = supply.given_of({"H_oil", "layer_m", "flow_m3_per_s", "profile"});
  if (two) ways.push_back(supply.given("layer1_m") ? "layer1_m" : "layer2_m");
  for (std::size_t k = 1; k < ways.size(); ++k)
    supply.complain(ways[k], "the supply is given as " + ways[0] + " already: keep one of them");
  if (two) supply.demand({"layer1_m", "layer2_m"}, "layer1_m and layer2_m belong together: 0 where there is none");
  if (!scales.in_SI)
    supply.refuse({"layer_m", "layer1_m", "layer2_m", "flow_m3_per_s"},
                  "is in SI and the contact is not: give H_oil, in units of H");
  input.H_oil = supply.number("H_oil");
  const double u_m = 0.5 * (scales.u1 + scales.u2);
  const double layer1 = supply.number("layer1_m"), layer2 = supply.number("layer2_m");
  const double layer = supply.number("layer_m"), flow = supply.number("flow_m3_per_s");
  if (supply.given("layer_m")) input.H_oil = layer / scales.height;
  if (supply.given("flow_m3_per_s")) input.H_oil = flow / (u_m * scales.width * scales.a) / scales.height;
  if (two) {
    input.H_oil = (scales.u1 * layer1 + scales.u2 * layer2) / u_m / scales.height;
    if (input.H_oil <= 0.0)
      supply.complain("layer1_m", "and layer2_m bring no oil at these speeds: u1 h1 + u2 h2 must be > 0");
  }
  input.profile = supply.word("profile");
  return input;
}

}  // namespace ehl::starvation
