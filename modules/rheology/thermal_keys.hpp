#pragma once
// What [thermal] says of the oil.
#include <vector>

#include "deck/deck.hpp"
#include "rheology/thermal_viscosity.hpp"

namespace ehl::rheology {

/// An oil whose temperature varies in the contact, in SI; what is open or wrong is NaN.
struct WarmOil {
  TemperatureConstants constants{};  ///< T0 is that of the oil that enters
  double k = 0.0;                    ///< [W/(m K)]
  double c = 0.0;                    ///< [J/(kg K)]
  double rho = 0.0;                  ///< [kg/m^3]
  double expansion = 0.0;            ///< [1/K]
  bool follows_pressure = true;      ///< k and c by Larsson and Andersson; else the same everywhere
};

/// The deck's keys of [thermal] about the oil.
std::vector<deck::Key> warm_oil_keys();
/// [lubricant] has been read: its temperature, kinematic viscosities and density are taken from there. What is missing,
/// given twice or without influence, and a law of viscosity without temperature, is added to deck.errors.
WarmOil read_warm_oil(deck::Deck& deck);

}  // namespace ehl::rheology
