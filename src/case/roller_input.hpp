#pragma once
// From the deck's [roller] to the gap across the motion.
#include <optional>

#include "case/scene.hpp"

namespace ehl::program {

/// What of a deck with a roller follows, and what is refused beside one, before the grid is made.
void settle_roller(deck::Deck& deck);

/// What the domain is chosen for: the profile and the tilt, where they say one. Complains in the deck.
std::optional<roller::Profile> roller_profile(deck::Deck& deck, const Physics& physics);

/// Adds the case's profile to the gap that its surfaces have. Complains in the case's deck.
void roller_input(Case& input);

}  // namespace ehl::program
