#pragma once
// Converts the deck's [roller] to a gap that varies along the roller.
#include <optional>

#include "case/scene.hpp"

namespace ehl::program {

/// Sets the keys that follow from a roller, and refuses keys that contradict one, before the grid is made.
void settle_roller(deck::Deck& deck);

/// The profile and the tilt, which the choice of the domain needs; nothing if the deck gives none.
/// Errors are added to the deck.
std::optional<roller::Profile> roller_profile(deck::Deck& deck, const Physics& physics);

/// Adds the profile of the roller to the gap of the case. Errors are added to its deck.
void roller_input(Case& input);

}  // namespace ehl::program
