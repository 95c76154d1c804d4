#pragma once
// Files that a deck names.
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ehl::deck {

/// The file that a key names: where the program runs, and else in the first of the deck's folders that has it.
/// in: a key whose value is the name of a file. errors: core::FileError with file, line and key where it is nowhere.
std::string found_beside(const Deck& deck, const std::string& section, const std::string& key);

/// A file that a deck names, and what tells it from another one.
struct NamedFile {
  std::string name{};  ///< as the deck has it
  std::string path{};  ///< where it was found
  std::uintmax_t bytes = 0;
  std::uint64_t hash = 0;
};

/// All of them, in the order of the keys. errors: core::FileError: missing, or not to be read.
std::vector<NamedFile> named_files(const Deck& deck);

/// "oil.csv: 812 bytes, 6f0d...", for what must notice that a file is another one.
std::string told(const NamedFile& file);

/// errors: core::FileError "oil.csv: cannot be read<note>: <why>": missing, larger, or no regular file: a pipe would
/// let the program wait for ever.
void check_readable(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// A text file to read, without the mark of UTF-8 that it may begin with. in: its largest size in bytes; what follows
/// the message. errors: as above.
std::ifstream opened(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// The whole of a text file, without the mark of UTF-8. errors: as above.
std::string content_of(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// After the last line. errors: core::FileError where the file could not be read to its end.
void check_read(const std::ifstream& file, const std::string& path);

/// The cells of a line: between semicolons where it has one, else between commas, and there every cell counts, an empty
/// one too; between blanks where it has neither. A comma beside semicolons is thus part of a cell, and "0,5" no number.
std::vector<std::string> cells_of(const std::string& line);

/// True where no cell is a number, or begins with one: then a first line is a heading.
bool is_heading(const std::vector<std::string>& cells);

/// A row of a table in a text file.
struct Row {
  std::string place{};  ///< "oil.csv:12"
  std::vector<std::string> cells{};
};

}  // namespace ehl::deck
