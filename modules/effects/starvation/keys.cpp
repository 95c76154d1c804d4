#include "effects/starvation/keys.hpp"

#include <algorithm>
#include <cmath>

#include "deck/record.hpp"

namespace ehl::starvation {
namespace {

/// Upper bound of the number of overrollings, each of which needs a solution. [bench: starvation_most_passes]
constexpr double most_passes = 10000.0;

deck::Records<Input> records() {
  using namespace deck::record;
  const auto dry = remedy("without oil there is no film: use [case] kind = dry");
  const std::string both = "layer1_m and layer2_m belong together: set 0 for a surface without oil";
  return {
      key("H_oil", &Input::H_oil, positive, example("0.2"),
          "Oil that both surfaces bring to the contact, in units of H: R (u1 h1 + u2 h2)/(u_m a^2). At and above the "
          "central film of the flooded contact it is nearly flooded; at a tenth of that film it is fully starved, and "
          "the layer passes through the contact.",
          dry, source("modules/effects/starvation/README.md")),
      key("layer_m", unit("m"), positive, example("200e-9"),
          "Thickness of the oil layer on both surfaces together, for a contact in SI.", dry),
      key("layer1_m", together({"layer2_m"}, both), unit("m"), not_negative, example("100e-9"),
          "Thickness of the oil layer on surface 1 alone, which arrives with the speed u1. Give layer1_m and "
          "layer2_m, or layer_m."),
      key("layer2_m", together({"layer1_m"}, both), unit("m"), not_negative, example("100e-9"),
          "Thickness of the oil layer on surface 2 alone, see layer1_m."),
      key("flow_m3_per_s", unit("m^3/s"), positive, example("1e-10"),
          "Oil flow to the inlet, spread evenly over the width of the domain.", dry),
      key("flow_m2_per_s", unit("m^2/s"), positive, example("1e-7"),
          "Oil flow to the inlet of a line contact, per length along y.", dry),
      key("profile", &Input::profile, file, example("track.csv"),
          "Oil layer across the track, as a CSV file with the columns y and h (both surfaces together), in metres or "
          "in the units of its heading, y [mm] and h [nm]; in units of X and H for a contact in M and L. It must "
          "cover the width of the domain."),
      key("passes", &Input::passes, Range{1.0, most_passes}, by_default("1"), example("20"),
          "Number of successive contacts on the same track: what leaves one contact is supplied to the next. The "
          "result is that of the last one, with a table of all.",
          source("modules/effects/starvation/README.md")),
      key("returning", by_default("both"), words({"both", "surface1", "surface2"}), needs("passes"),
          example("surface1"),
          "Surfaces that carry the oil of one pass to the next. The other surface brings its initial layer every "
          "time."),
      key("split", Range{0.0, 1.0}, needs("returning", {"surface1", "surface2"}), example("0.5"),
          otherwise("u1/(u1 + u2): equal layers on both surfaces"),
          "Share of the oil leaving the contact that stays on surface 1."),
      key("pass_time", unit("s"), positive, needs("passes"), example("0.05"),
          "Time from one pass to the next, used for the reflow and for the film against time."),
      key("reflow_time", unit("s"), positive, needs("pass_time"), example("10"), otherwise("none: no oil flows back"),
          "Time in which differences of the layer across the track decay to 1/e, towards the mean over the width of "
          "the domain. Surface tension is far too slow for that in bearings.",
          source("modules/effects/starvation/README.md"))};
}

}  // namespace

std::vector<deck::Key> keys() { return deck::keys_of("supply", records()); }

const std::vector<std::string>& supply_keys() {
  static const std::vector<std::string> all{"H_oil",         "layer_m",       "layer1_m", "layer2_m",
                                            "flow_m3_per_s", "flow_m2_per_s", "profile"};
  return all;
}

bool called_for(const deck::Deck& deck) {
  return std::ranges::any_of(supply_keys(), [&](const std::string& name) { return deck::given(deck, "supply", name); });
}

Input read(deck::Deck& deck, const Scales& scales) {
  const deck::Part supply{deck, "supply"};
  Input input = deck::read(supply, records());
  const bool two = supply.given("layer1_m") || supply.given("layer2_m");
  std::vector<std::string> supply_keys =
      supply.given_of({"H_oil", "layer_m", "flow_m3_per_s", "flow_m2_per_s", "profile"});
  if (two) supply_keys.push_back(supply.given("layer1_m") ? "layer1_m" : "layer2_m");
  for (std::size_t k = 1; k < supply_keys.size(); ++k)
    supply.complain(supply_keys[k], "the supply is already given by " + supply_keys[0] + ": keep one of them");
  if (!scales.in_SI)
    supply.refuse({"layer_m", "layer1_m", "layer2_m", "flow_m3_per_s", "flow_m2_per_s"},
                  "is in SI, but the contact is not: give H_oil, in units of H");
  if (scales.line) {
    supply.refuse({"flow_m3_per_s"}, "is not for a line contact, which has no width: give flow_m2_per_s");
    supply.refuse({"profile"}, "varies along y, and a line contact does not: give one layer");
    if (input.passes > 1)
      supply.complain("passes",
                      "is not for a line contact: no oil flows sideways, so all passes are the same; remove it");
  } else if (scales.point) {
    supply.refuse({"flow_m2_per_s"}, "belongs to a line contact: give flow_m3_per_s");
  }
  const double u_m = 0.5 * (scales.u1 + scales.u2);
  const double layer1 = supply.number("layer1_m"), layer2 = supply.number("layer2_m");
  const double layer = supply.number("layer_m"), flow = supply.number("flow_m3_per_s");
  if (supply.given("layer_m")) input.H_oil = layer / scales.height;
  if (supply.given("flow_m3_per_s")) input.H_oil = flow / (u_m * scales.width * scales.a) / scales.height;
  if (supply.given("flow_m2_per_s")) input.H_oil = supply.number("flow_m2_per_s") / u_m / scales.height;
  // Shares of surface 1 in the outflow and in the supply.
  const double on_1 = scales.in_SI ? scales.u1 / (scales.u1 + scales.u2) : 0.5;
  const double split = supply.given("split") ? supply.number("split") : on_1;
  double brought_on_1 = on_1;
  if (two) brought_on_1 = scales.u1 * layer1 / (scales.u1 * layer1 + scales.u2 * layer2);
  input.returning = supply.choice("returning", {1.0, split, 1.0 - split});
  input.renewed = supply.choice("returning", {0.0, 1.0 - brought_on_1, brought_on_1});
  if (supply.given("reflow_time"))
    input.levelled = 1.0 - std::exp(-supply.number("pass_time") / supply.number("reflow_time"));
  if (two) {
    input.H_oil = (scales.u1 * layer1 + scales.u2 * layer2) / u_m / scales.height;
    if (input.H_oil <= 0.0)
      supply.complain("layer1_m", "and layer2_m supply no oil at these speeds: u1 h1 + u2 h2 must be > 0");
    input.layer1 = layer1 / scales.height / input.H_oil;
    input.layer2 = layer2 / scales.height / input.H_oil;
  }
  input.is_flow = supply.given("flow_m3_per_s") || supply.given("flow_m2_per_s");
  return input;
}

}  // namespace ehl::starvation
