#pragma once
// Decks and lists of keys written by the program from the key records: nothing is described twice.
#include <string>

#include "deck/deck.hpp"
#include "deck/key.hpp"

namespace ehl::deck {

/// The list for `ehl keys`: every key with default, unit, range, meaning, source.
/// in: selection "", "section" or "section.key". errors: core::InputError for an unknown selection, with the nearest
/// name.
std::string list_keys(const Catalogue& catalogue, const std::string& selection);

/// A complete commented deck: active lines make it a valid deck, the alternatives are commented out.
std::string commented_deck(const Catalogue& catalogue);

/// The deck as it was understood: given, default and chosen values. Read again it gives the same case.
std::string effective_deck(const Deck& deck);

}  // namespace ehl::deck
