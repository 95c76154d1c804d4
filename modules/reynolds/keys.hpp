#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// The keys of the deck's section [discretization], and their values.
std::vector<deck::Key> keys();
Wedge read(deck::Deck& deck);
Face read_face(deck::Deck& deck);

}  // namespace ehl::reynolds
