#pragma once
// What [thermal] says of the bodies and of the way in which the heat is computed.
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ehl::thermal {

/// A body, in SI.
struct BodyInput {
  double T = 0.0;                      ///< far from the contact [C]
  double k = 0.0, c = 0.0, rho = 0.0;  ///< [W/(m K)], [J/(kg K)], [kg/m^3]
};

struct Input {
  BodyInput body_1{}, body_2{};
  int intervals = 16;  ///< across the film
  bool convection = true, compression = true;
  bool lines = false;                 ///< bodies by Carslaw and Jaeger's lines
  std::vector<std::string> fields{};  ///< to keep in the result
};

/// The deck's keys of [thermal] but those of the oil (rheology/thermal_keys.hpp).
std::vector<deck::Key> keys();
/// [thermal] T_oil is known. What is missing or given twice is added to deck.errors.
Input read(deck::Deck& deck);

}  // namespace ehl::thermal
