#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::mlmi {

/// The keys of the deck's section [deformation], and their values.
std::vector<deck::Key> keys();
Parameters read(deck::Deck& deck);

}  // namespace ehl::mlmi
