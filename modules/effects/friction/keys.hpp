#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "effects/friction/friction.hpp"

namespace ehl::friction {

/// The deck keys of this effect: section [friction].
std::vector<deck::Key> keys();
/// Reads [friction]; stress and slope follow from the contact and are set elsewhere.
Parameters read(deck::Deck& deck);

}  // namespace ehl::friction
