#pragma once
// Keys of [supply].
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "deck/deck.hpp"

namespace ehl::starvation {

/// Scales of the contact in SI; NaN: not known.
struct Scales {
  double a = core::unknown;       ///< [m], of X and Y
  double height = core::unknown;  ///< a^2/R [m], of H
  double u1 = core::unknown;      ///< [m/s]
  double u2 = core::unknown;      ///< [m/s]
  double width = core::unknown;   ///< of the domain, in a
  bool in_SI = false;
  bool line = false;   ///< the contact is a line contact
  bool point = false;  ///< the contact is finite along y; if neither is true the deck is wrong
};

/// The supply of a deck: either H_oil or a profile; and repeated overrolling.
struct Input {
  double H_oil = core::unknown;  ///< everywhere; NaN: see `profile`
  std::string profile{};         ///< name of a file, as in the deck
  /// Layers on each surface if given separately, over H_oil.
  double layer1 = core::unknown;
  double layer2 = core::unknown;
  bool is_flow = false;
  int passes = 1;
  double returning = 1.0;  ///< share of the outflow that returns to the inlet
  double renewed = 0.0;    ///< share of the supply that is fresh at each overrolling
  double levelled = 0.0;   ///< share of the differences across the track that levels out between two overrollings
};

/// Keys of [supply].
std::vector<deck::Key> keys();
/// Keys that give a supply: one of them, or both layers.
const std::vector<std::string>& supply_keys();
/// True if the deck gives a supply.
bool called_for(const deck::Deck& deck);
/// Reports keys that contradict each other or need a contact in SI.
Input read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::starvation
