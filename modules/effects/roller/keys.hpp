#pragma once
// Keys of [roller].
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "deck/deck.hpp"
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// Scales of the contact, most of them in SI; NaN: not known.
struct Scales {
  double length = core::unknown;  ///< of the roller, in a
  double a = core::unknown;       ///< [m], of X and Y
  double radius = core::unknown;  ///< R_x [m]
  double load = core::unknown;    ///< [N]
  double a_over_R = core::unknown;
  bool in_SI = false;
};

/// Keys of [roller].
std::vector<deck::Key> keys();
/// Reports keys that contradict each other and tables that do not describe a roller.
Profile read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::roller
