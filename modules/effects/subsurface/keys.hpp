#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "effects/subsurface/stress.hpp"

namespace ehl::subsurface {

/// The deck keys of this effect: section [subsurface].
std::vector<deck::Key> keys();
/// in: Poisson's ratio of body 1, for a deck that gives none here; NaN where it gives none at all; whether the friction
/// of the contact is computed, which a deck that gives no traction here takes.
Parameters read(deck::Deck& deck, double nu1, bool friction_is_computed);

}  // namespace ehl::subsurface
