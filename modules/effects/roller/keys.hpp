#pragma once
// Keys of [roller].
#include <limits>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Scales of the contact, most of them in SI; NaN: not known.
struct Scales {
  double length = std::numeric_limits<double>::quiet_NaN();  ///< of the roller, in a
  double a = std::numeric_limits<double>::quiet_NaN();       ///< [m], of X and Y
  double radius = std::numeric_limits<double>::quiet_NaN();  ///< R_x [m]
  double load = std::numeric_limits<double>::quiet_NaN();    ///< [N]
  double a_over_R = std::numeric_limits<double>::quiet_NaN();
  bool in_SI = false;
};

/// Keys of [roller].
std::vector<deck::Key> keys();
/// Reports keys that contradict each other and tables that do not describe a roller.
Profile read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::roller
