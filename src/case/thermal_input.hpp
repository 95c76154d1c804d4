#pragma once
// From the deck's [thermal] to the film's temperature: groups, laws and bodies in the contact's own units.
#include <optional>
#include <string>
#include <vector>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::program {

struct HeatInput {
  thermal::Setup setup{};  ///< but for the patch and the threads
  double T0 = 0.0;         ///< of the oil that enters [K]; theta = (T - T0)/T0
  double beta = 0.0;       ///< -d ln eta/dT there, at ambient pressure [1/K]
  double k = 0.0;          ///< of the oil at ambient pressure [W/(m K)]
  double power = 0.0;      ///< the unit of heat that flows: k T0 R [W]; of a line contact k T0 R/a [W/m]
  std::vector<std::string> fields{};
};

/// Nothing where the deck has no [thermal]; complains in the deck about what is missing, contradictory or not possible
/// with heat. in: the scene but for its effects; the limiting stress over pressure.
std::optional<HeatInput> thermal_input(deck::Deck& deck, const Physics& physics, const steady::Scene& scene,
                                       double limit);

}  // namespace ehl::program
