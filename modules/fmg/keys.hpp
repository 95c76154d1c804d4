#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "fmg/parameters.hpp"

namespace ehl::fmg {

/// The deck's keys of [multigrid].
std::vector<deck::Key> keys();
Parameters read(deck::Deck& deck);

}  // namespace ehl::fmg
