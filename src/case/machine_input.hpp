#pragma once
// The contact of a bearing or of gears: from the deck, into [contact] and [motion].
#include <optional>

#include "deck/deck.hpp"
#include "machines/number.hpp"

namespace ehl::program {

/// Nothing where [case] kind names none. Else load, radii and speeds are recorded in the deck as [contact] and [motion]
/// would give them, and those sections may hold what they do not settle: the bodies' moduli and roughness. Complains.
std::optional<machines::Contact> machine_input(deck::Deck& deck);

}  // namespace ehl::program
