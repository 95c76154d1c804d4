// What the surfaces carry through the contact.
#include <cmath>
#include <numbers>

#include "deck/text.hpp"
#include "effects.hpp"
#include "text_format.hpp"

namespace ehl::program {
namespace {

/// A surface of the deck with its feature in the case.
struct Carrier {
  const char* section;
  const std::optional<transient::Feature>* feature;
};

std::vector<Carrier> carriers(const Case& input) {
  std::vector<Carrier> list;
  if (!input.transient) return list;
  const transient::Conditions& conditions = input.transient->conditions;
  if (conditions.on_1) list.push_back({"surface1", &conditions.on_1});
  if (conditions.on_2) list.push_back({"surface2", &conditions.on_2});
  return list;
}

std::string what(const Case& input) {
  std::vector<std::string> shapes;
  for (const Carrier& carrier : carriers(input))
    shapes.push_back(deck::word(input.deck, carrier.section, "shape") + " on " + carrier.section);
  return deck::joined(shapes, ", ");
}

std::string asymmetry(const Case& input) {
  std::vector<std::string> reasons;
  for (const Carrier& carrier : carriers(input)) {
    const transient::Feature& feature = **carrier.feature;
    if (transient::symmetric(feature)) continue;
    const std::string lies = feature.Y != 0.0 ? formatted(" at y = %.4g", feature.Y)
                                              : formatted(" at %.4g degrees", feature.angle * 180.0 / std::numbers::pi);
    reasons.push_back(deck::word(input.deck, carrier.section, "shape") + " of " + carrier.section + lies);
  }
  return deck::joined(reasons, ", ");
}

// Evaluating the shape at every step; and where it is not symmetric, the other half of the domain in time.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  constexpr double share_of_a_step = 0.05;  // of the time that a step takes
  const Needs one_half = transient_effect().expense(input);
  Needs more{.bytes = nodes * sizeof(double), .seconds = share_of_a_step * one_half.seconds};
  if (asymmetry(input).empty()) return more;
  constexpr double doubles_of_history = 30.0;  // as those of effect_transient.cpp
  more.bytes += nodes * sizeof(double) * doubles_of_history;
  more.seconds = 2.0 * more.seconds + one_half.seconds;
  return more;
}

}  // namespace

Effect surfaces_effect() {
  return {.name = "surfaces",
          .meaning = "What a surface carries through the contact, with its own speed.",
          .without = "smooth",
          .sections = {{.name = "surface1",
                        .meaning = "What surface 1 carries through the contact, with its own speed. Only with "
                                   "[transient].",
                        .called_by = {"shape"}},
                       {.name = "surface2",
                        .meaning = "What surface 2 carries through the contact. Only with [transient].",
                        .called_by = {"shape"}}},
          .callers = {{"surface1", "shape"}, {"surface2", "shape"}},
          .on = [](const Case& input) { return !carriers(input).empty(); },
          .what = what,
          .expense = expense,
          .asymmetry = asymmetry,
          .seconds =
              [](const Computed& computed) {
                return computed.in_time ? computed.in_time->report.seconds_of_surfaces : 0.0;
              },
          .example = {"surface1.shape=dimple", "surface1.height=0.05", "surface1.width=0.5", "surface1.x=-0.5"},
          .upon = "transient"};
}

}  // namespace ehl::program
