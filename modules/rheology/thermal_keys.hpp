#pragma once
// Keys of [thermal] about the oil.
#include <vector>

#include "deck/deck.hpp"
#include "rheology/thermal_viscosity.hpp"

namespace ehl::rheology {

/// An oil whose temperature varies in the contact, in SI; NaN: not given or wrong.
struct WarmOil {
  TemperatureConstants constants{};  ///< T0 is the temperature of the oil at the inlet
  double k = 0.0;                    ///< [W/(m K)]
  double c = 0.0;                    ///< [J/(kg K)]
  double rho = 0.0;                  ///< [kg/m^3]
  double expansion = 0.0;            ///< [1/K]
  bool follows_pressure = true;      ///< k and c by Larsson and Andersson; else constant
};

/// Keys of [thermal] about the oil.
std::vector<deck::Key> warm_oil_keys();
/// Reads them. in: [lubricant] has been read; its temperature, kinematic viscosities and density are used. Keys that
/// are missing, given twice or without effect, and a viscosity law without temperature, are added to deck.errors.
WarmOil read_warm_oil(deck::Deck& deck);

}  // namespace ehl::rheology
