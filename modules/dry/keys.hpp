#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "dry/solve.hpp"

namespace ehl::dry {

/// The deck keys of the dry contact: [case] kind and section [dry].
std::vector<deck::Key> keys();
/// Nothing where the contact is lubricated.
std::optional<Parameters> read(deck::Deck& deck);

}  // namespace ehl::dry
