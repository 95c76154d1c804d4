#include "deck/file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::deck {

std::string found_beside(const Deck& deck, const std::string& section, const std::string& key) {
  namespace files = std::filesystem;
  const std::string file = word(deck, section, key);
  std::error_code error;
  if (files::exists(file, error)) return file;
  for (const std::string& folder : deck.folders) {
    const files::path beside = files::path(folder) / file;
    if (files::exists(beside, error)) return beside.string();
  }
  const std::string place = value(deck, section, key).place;
  std::string message = place.empty() ? deck.name : place;
  message += ": [" + section + "] " + key + " = " + file + ": there is no such file where the program runs";
  for (const std::string& folder : deck.folders) message += ", nor in " + folder;
  throw core::FileError(message);
}

std::ifstream opened(const std::string& path, const std::string& note) {
  std::error_code error;
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path, error)) throw core::FileError(path + ": cannot be read" + note);
  return file;
}

std::vector<Row> rows_of(const std::string& path, const std::string& note) {
  std::ifstream file = opened(path, note);
  std::vector<Row> rows;
  int number = 0;
  bool heading_allowed = true;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    std::ranges::replace(line, ';', ',');
    const std::vector<std::string> cells = split_words(trimmed(line));
    if (cells.empty()) continue;
    if (!heading_allowed || std::isfinite(read_number(cells[0]).value))
      rows.push_back({path + ":" + std::to_string(number), cells});
    heading_allowed = false;
  }
  return rows;
}

}  // namespace ehl::deck
