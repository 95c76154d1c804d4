#include "deck/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

namespace files = std::filesystem;

constexpr std::uintmax_t largest_named_file = 4'000'000'000;  // bytes; a map of 10^8 heights with all digits

NamedFile read(const std::string& name, const std::string& path) {
  std::ifstream file = opened(path, largest_named_file);
  file.seekg(0);
  NamedFile found{name, path, 0, hash_of_nothing};
  std::array<char, 1 << 16> piece{};
  while (file) {
    file.read(piece.data(), piece.size());
    const auto count = static_cast<std::size_t>(file.gcount());
    found.hash = hash({piece.data(), count}, found.hash);
    found.bytes += count;
  }
  check_read(file, path);
  return found;
}

}  // namespace

std::string found_beside(const Deck& deck, const std::string& section, const std::string& key) {
  const std::string file = word(deck, section, key);
  std::error_code error;
  if (files::exists(file, error)) return file;
  for (const std::string& folder : deck.folders) {
    const files::path beside = files::path(folder) / file;
    if (files::exists(beside, error)) return beside.string();
  }
  const std::string place = value(deck, section, key).place;
  std::string message = place.empty() ? deck.name : place;
  message += ": [" + section + "] " + key + " = " + file + ": there is no such file in the working folder";
  for (const std::string& folder : deck.folders) message += ", nor in " + folder;
  const Key& record = *find_key(deck.catalogue, section, key);
  if (record.names == Names::file_or_list) message += "; a list is written as in " + record.example;
  throw core::FileError(message);
}

std::vector<NamedFile> named_files(const Deck& deck) {
  std::vector<NamedFile> found;
  for (const Key& key : deck.catalogue.keys) {
    if (!given(deck, key.section, key.name)) continue;
    const std::string name = word(deck, key.section, key.name);
    if (names_file(key, name)) found.push_back(read(name, found_beside(deck, key.section, key.name)));
  }
  return found;
}

std::string fingerprint(const NamedFile& file) {
  return fmt::format("{}: {} bytes, {:016x}", file.name, file.bytes, file.hash);
}

void check_readable(const std::string& path, std::uintmax_t largest, const std::string& note) {
  std::error_code error;
  const auto fail = [&](const std::string& why) {
    throw core::FileError(path + ": cannot be read" + note + ": " + why);
  };
  const files::file_status status = files::status(path, error);
  if (!files::exists(status)) fail(error ? error.message() : std::strerror(ENOENT));
  if (files::is_directory(status)) fail("this is a directory");
  if (!files::is_regular_file(status)) fail("this is not a regular file");
  if (files::file_size(path, error) > largest && !error)
    fail(fmt::format("it is larger than {:.0f} MB", static_cast<double>(largest) * 1e-6));
}

std::ifstream opened(const std::string& path, std::uintmax_t largest, const std::string& note) {
  check_readable(path, largest, note);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::FileError(path + ": cannot be read" + note + ": " + std::strerror(errno));
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  char first[mark.size()] = {};
  file.read(first, mark.size());
  if (std::string_view(first, mark.size()) != mark) {
    file.clear(file.rdstate() & std::ios::badbit);  // the file may be shorter than the mark
    file.seekg(0);
  }
  return file;
}

void check_read(const std::ifstream& file, const std::string& path) {
  if (file.bad()) throw core::FileError(path + ": cannot be read to its end");
}

std::string content_of(const std::string& path, std::uintmax_t largest, const std::string& note) {
  std::ifstream file = opened(path, largest, note);
  std::string content;
  std::array<char, 1 << 16> piece{};
  while (file) {
    file.read(piece.data(), piece.size());
    content.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  check_read(file, path);
  return content;
}

}  // namespace ehl::deck
