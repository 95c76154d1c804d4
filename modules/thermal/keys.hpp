#pragma once
// Keys of [thermal] about the bodies and the method.
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ehl::thermal {

/// A body, in SI.
struct BodyInput {
  double T = 0.0;                      ///< far from the contact [C]
  double k = 0.0, c = 0.0, rho = 0.0;  ///< [W/(m K)], [J/(kg K)], [kg/m^3]
};

/// What [thermal] says about the bodies and the method.
struct Input {
  BodyInput body_1{}, body_2{};
  int intervals = 16;  ///< across the film
  bool convection = true, compression = true;
  bool lines = false;                 ///< line sources of Carslaw and Jaeger
  std::vector<std::string> fields{};  ///< kept in the result
};

/// Keys of [thermal] except those of the oil (rheology/thermal_keys.hpp).
std::vector<deck::Key> keys();
/// in: [thermal] T_oil is given. Reports missing and contradictory keys in deck.errors.
Input read(deck::Deck& deck);

}  // namespace ehl::thermal
