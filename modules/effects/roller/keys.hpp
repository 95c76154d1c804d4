#pragma once
// The keys of [roller].
#include <limits>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "effects/roller/profile.hpp"

namespace ehl::roller {

/// The scales of a contact, most of them in SI; not known: NaN.
struct Scales {
  double length = std::numeric_limits<double>::quiet_NaN();  ///< of the roller, in a: of every contact
  double a = std::numeric_limits<double>::quiet_NaN();       ///< m, of X and Y
  double radius = std::numeric_limits<double>::quiet_NaN();  ///< m, R_x
  double load = std::numeric_limits<double>::quiet_NaN();    ///< N
  double a_over_R = std::numeric_limits<double>::quiet_NaN();
  bool in_SI = false;
};

std::vector<deck::Key> keys();
/// Complains where keys do not go together, or a table says nothing of the roller.
Profile read(deck::Deck& deck, const Scales& scales);

}  // namespace ehl::roller
