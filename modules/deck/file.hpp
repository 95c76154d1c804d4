#pragma once
// Files that a deck names.
#include <fstream>
#include <string>

#include "deck/deck.hpp"

namespace ehl::deck {

/// The file that a key names: where the program runs, and else in the first of the deck's folders that has it.
/// in: a key whose value is the name of a file. errors: core::FileError with file, line and key where it is nowhere.
std::string found_beside(const Deck& deck, const std::string& section, const std::string& key);

/// A text file to read. in: what follows the message. errors: core::FileError where it cannot be read.
std::ifstream opened(const std::string& path, const std::string& note = {});

/// A row of a table in a text file.
struct Row {
  std::string place{};  ///< "oil.csv:12"
  std::vector<std::string> cells{};
};

/// The rows of a CSV file: cells between commas, semicolons or blanks; # begins a comment; a first row of words is a
/// heading, and left out. errors: core::FileError where it cannot be read.
std::vector<Row> rows_of(const std::string& path, const std::string& note = {});

}  // namespace ehl::deck
