#pragma once
// Files that a deck names.
#include <string>

namespace ehl::program {

/// The file where the program runs, and else beside the deck; as it is named where it is in neither place, so that the
/// reader says what is missing. in: the file as the deck names it; path of the deck.
std::string found_beside(const std::string& file, const std::string& deck);

}  // namespace ehl::program
