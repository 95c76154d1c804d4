#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "multigrid/parameters.hpp"

namespace ehl::multigrid {

/// The keys of the deck's section [multigrid].
std::vector<deck::Key> keys();
/// The values of these keys. errors: reported to the deck: an even kernel_terms; pre + post = 0.
Parameters read(deck::Deck& deck);

}  // namespace ehl::multigrid
