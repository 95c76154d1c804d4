#pragma once
// Converts the deck's [bearing] or [gear] to [contact] and [motion].
#include <optional>

#include "deck/deck.hpp"
#include "machines/number.hpp"

namespace ehl::program {

/// Nothing if [case] kind names no machine. Otherwise load, radii and speeds are recorded in the deck as keys of
/// [contact] and [motion]. In these sections the deck may still give what does not follow from the machine: moduli and
/// roughness of the bodies. Errors are added to the deck.
std::optional<machines::Contact> machine_input(deck::Deck& deck);

}  // namespace ehl::program
