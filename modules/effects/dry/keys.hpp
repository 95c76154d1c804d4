#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "effects/dry/solve.hpp"

namespace ehl::dry {

/// The deck keys of this effect: [case] kind and section [dry].
std::vector<deck::Key> keys();
/// Nothing where the contact is lubricated.
std::optional<Parameters> read(deck::Deck& deck);

}  // namespace ehl::dry
