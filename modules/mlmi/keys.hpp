#pragma once
#include <vector>

#include "deck/deck.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::mlmi {

/// The deck's keys of [deformation].
std::vector<deck::Key> keys();
Parameters read(deck::Deck& deck);

}  // namespace ehl::mlmi
