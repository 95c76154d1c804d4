#pragma once
// Files that a deck names.
#include <string>

#include "deck/deck.hpp"

namespace ehl::program {

/// The file that a key names: where the program runs, and else in the first of the deck's folders that has it.
/// in: a key whose value is the name of a file. errors: core::FileError with file, line and key where it is nowhere.
std::string found_beside(const deck::Deck& deck, const std::string& section, const std::string& key);

}  // namespace ehl::program
