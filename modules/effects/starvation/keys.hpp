#pragma once
// The keys of [supply].
#include <limits>
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ehl::starvation {

/// The scales of a contact in SI; not known: NaN.
struct Scales {
  double a = std::numeric_limits<double>::quiet_NaN();       ///< m, of X and Y
  double height = std::numeric_limits<double>::quiet_NaN();  ///< m, a^2/R, of H
  double u1 = std::numeric_limits<double>::quiet_NaN();      ///< m/s
  double u2 = std::numeric_limits<double>::quiet_NaN();      ///< m/s
  double width = std::numeric_limits<double>::quiet_NaN();   ///< of the domain, in a
  bool in_SI = false;
  bool line = false;   ///< a line contact
  bool point = false;  ///< of an extent along y; neither: not known, the deck is wrong
};

/// What the deck says: one of both; and of repeated passes.
struct Input {
  double H_oil = std::numeric_limits<double>::quiet_NaN();  ///< everywhere; NaN: the profile says
  std::string profile{};                                    ///< the key's value, the name of a file
  /// Of each surface, where they are given apart, over H_oil.
  double layer1 = std::numeric_limits<double>::quiet_NaN();
  double layer2 = std::numeric_limits<double>::quiet_NaN();
  bool is_flow = false;
  int passes = 1;
  double returning = 1.0;  ///< share of what leaves that comes back
  double renewed = 0.0;    ///< share of the supply that is brought anew every time
  double levelled = 0.0;   ///< share of the differences across the track that levels out between two
};

std::vector<deck::Key> keys();
/// The keys of which one, or both layers, give a supply.
const std::vector<std::string>& ways();
/// True when the deck gives a supply.
bool called_for(const deck::Deck& deck);
/// Complains where keys do not go together, or need a contact in SI.
Input read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::starvation
