#pragma once
#include <optional>
#include <vector>

#include "deck/deck.hpp"
#include "dry/solve.hpp"

namespace ehl::dry {

/// Keys of the dry contact: [case] kind and section [dry].
std::vector<deck::Key> keys();
/// Reads them; nullopt if the contact is lubricated.
std::optional<Parameters> read(deck::Deck& deck);

}  // namespace ehl::dry
