#pragma once
// Converts the deck's section of a machine to [contact] and [motion], and an impact also to [transient] and [body].
#include <optional>

#include "deck/deck.hpp"
#include "machines/number.hpp"

namespace ehl::program {

/// Nothing if [case] kind names no machine. Otherwise what follows from the machine (load, radii, speeds) is recorded
/// in the deck as keys of [contact] and [motion]; the deck may still give what does not follow, such as moduli and
/// roughness of the bodies. [transient] cycle = machine makes one course the time of the run. Errors are added to the
/// deck.
std::optional<machines::Contact> machine_input(deck::Deck& deck);

}  // namespace ehl::program
