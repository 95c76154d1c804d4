#pragma once
// Converts the deck's [thermal] to groups, laws and bodies in the units of the contact.
#include <optional>
#include <string>
#include <vector>

#include "case/physical_input.hpp"
#include "deck/deck.hpp"
#include "steady/scene.hpp"
#include "thermal/film_temperature.hpp"

namespace ehl::program {

struct HeatInput {
  thermal::Setup setup{};  ///< complete except for the patch and the threads
  double T0 = 0.0;         ///< temperature of the oil that enters [K]; theta = (T - T0)/T0
  double beta = 0.0;       ///< -d ln eta/dT at T0 and ambient pressure [1/K]
  double k = 0.0;          ///< conductivity of the oil at ambient pressure [W/(m K)]
  double power = 0.0;      ///< unit of heat flow: k T0 R [W]; for a line contact k T0 R/a [W/m]
  std::vector<std::string> fields{};
};

/// Nothing if the deck has no [thermal]. Errors (missing, contradictory or unavailable settings) are added to the deck.
/// in: the scene except for its effects; limit: limiting shear stress divided by pressure.
std::optional<HeatInput> thermal_input(deck::Deck& deck, const Physics& physics, const steady::Scene& scene,
                                       double limit);

}  // namespace ehl::program
