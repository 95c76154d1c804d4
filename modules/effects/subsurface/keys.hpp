#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "effects/subsurface/stress.hpp"

namespace ehl::subsurface {

/// The deck keys of this effect: section [subsurface].
std::vector<deck::Key> keys();
/// in: nu1, Poisson's ratio of body 1, used unless the deck gives one here; NaN: not given; friction_is_computed: the
/// computed friction is used unless the deck gives a traction here.
Parameters read(deck::Deck& deck, double nu1, bool friction_is_computed);

}  // namespace ehl::subsurface
