#pragma once
// The deck's [supply], into the scene.
#include "case/scene.hpp"

namespace ehl::program {

/// Behind a meniscus there is no oil and no pressure: with a supply the boundary of the domain has P = 0. Complains
/// where the deck asks for the far field of a flooded contact. To be called before a domain is chosen.
void settle_boundary_of_supply(deck::Deck& deck);

/// scene.supply; nothing where the deck gives none. Complains in the deck, of its files too.
void supply_input(Case& input);

}  // namespace ehl::program
