#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "effects/subsurface/stress.hpp"

namespace ehl::subsurface {

/// The deck keys of this effect: section [subsurface].
std::vector<deck::Key> keys();
/// in: Poisson's ratio of body 1, for a deck that gives none here; NaN where it gives none at all.
Parameters read(deck::Deck& deck, double nu1);

}  // namespace ehl::subsurface
