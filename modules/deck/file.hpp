#pragma once
// Files named by a deck.
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ehl::deck {

/// Path of the file that a key names: in the current directory, else in the first of the deck's folders that has it.
/// in: a key whose value is a file name. errors: core::FileError with file, line and key if it is not found.
std::string found_beside(const Deck& deck, const std::string& section, const std::string& key);

/// A file named by a deck, with size and hash to identify its content.
struct NamedFile {
  std::string name{};  ///< as in the deck
  std::string path{};  ///< where it was found
  std::uintmax_t bytes = 0;
  std::uint64_t hash = 0;
};

/// All of them, in the order of the keys. errors: core::FileError if one is missing or cannot be read.
std::vector<NamedFile> named_files(const Deck& deck);

/// "oil.csv: 812 bytes, 6f0d...", a text that changes with the content of the file.
std::string fingerprint(const NamedFile& file);

/// errors: core::FileError "oil.csv: cannot be read<note>: <why>" if the file is missing, larger, or not a regular
/// file; a pipe would block the program.
void check_readable(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// Opens a text file and skips the UTF-8 byte order mark. in: largest size in bytes; note, appended to messages.
/// errors: as above.
std::ifstream opened(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// Content of a text file without the byte order mark. errors: as above.
std::string content_of(const std::string& path, std::uintmax_t largest, const std::string& note = {});

/// To be called after the last line. errors: core::FileError if the file could not be read to its end.
void check_read(const std::ifstream& file, const std::string& path);

/// A row of a table in a text file.
struct Row {
  std::string place{};  ///< "oil.csv:12"
  std::vector<std::string> cells{};
};

}  // namespace ehl::deck
