#pragma once
// Reads the deck's [supply] into the scene.
#include "case/scene.hpp"

namespace ehl::program {

/// With a supply, there is neither oil nor pressure outside the meniscus, so the boundary of the domain gets P = 0. An
/// error is added if the deck asks for the far field of a flooded contact. Call it before the domain is chosen.
void settle_boundary_of_supply(deck::Deck& deck);

/// Sets scene.supply; leaves it empty if the deck has no supply. Errors in the deck and in its
/// files are added to the deck.
void supply_input(Case& input);

}  // namespace ehl::program
