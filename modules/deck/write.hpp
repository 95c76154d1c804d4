#pragma once
// Decks and lists of keys generated from the key records, so that nothing is described twice.
#include <string>

#include "deck/deck.hpp"
#include "deck/key.hpp"

namespace ehl::deck {

/// List for `ehl keys`: every key with default, unit, range, meaning and source.
/// in: selection "", "section" or "section.key". errors: core::InputError for an unknown selection, with the nearest
/// name.
std::string list_keys(const Catalogue& catalogue, const std::string& selection);

/// A complete commented deck: the active lines are a valid deck, alternatives are commented out.
std::string commented_deck(const Catalogue& catalogue);

/// The deck with given, default and chosen values. Reading it again gives the same case.
std::string effective_deck(const Deck& deck);

}  // namespace ehl::deck
