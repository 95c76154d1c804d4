#pragma once
// From the deck's [roller] to the gap across the motion.
#include "case/scene.hpp"

namespace ehl::program {

/// What of a deck with a roller follows, and what is refused beside one, before the grid is made.
void settle_roller(deck::Deck& deck);

/// The case's profile, which it adds to the gap that its surfaces have. Complains in the case's deck.
void roller_input(Case& input);

}  // namespace ehl::program
