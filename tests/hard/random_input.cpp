// The decks of inputs/ with other numbers on small meshes: bearings, gears, rollers, oils of data sheets, and whatever
// else has a deck there.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

namespace fs = std::filesystem;
using Entries = std::vector<Entry>;

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Entries entries_of(const std::string& deck) {
  Entries entries;
  std::string section;
  std::istringstream lines(deck);
  for (std::string line; std::getline(lines, line);) {
    line = trimmed(line.substr(0, line.find_first_of("#;")));
    if (line.starts_with('['))
      section = line.substr(1, line.find(']') - 1);
    else if (const std::size_t equals = line.find('='); equals != std::string::npos)
      entries.push_back({section, trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1))});
  }
  return entries;
}

/// The decks below a folder, in the order of their names.
std::vector<fs::path> decks_below(const std::string& folder) {
  std::vector<fs::path> decks;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".ini") decks.push_back(entry.path());
  std::ranges::sort(decks);
  return decks;
}

/// The value times a factor, as a whole number where it was one; words, lists and names stay.
std::string scaled(const std::string& value, double factor) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (value.empty() || *end != '\0') return value;
  const bool is_whole = value.find_first_of(".e") == std::string::npos;
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", is_whole ? std::round(number * factor) : number * factor);
  return buffer;
}

/// A mesh, a time and numbers of planes and passes that cost little.
void make_small(Entries& entries, Random& random) {
  const auto is = [](const Entry& entry, const char* section, const char* name) {
    return entry.section == section && entry.name == name;
  };
  std::erase_if(entries, [&](const Entry& entry) {
    return entry.section == "grid" || is(entry, "subsurface", "planes") || is(entry, "supply", "passes");
  });
  const auto any = [&](auto holds) { return std::ranges::any_of(entries, holds); };
  const bool line = any([&](const Entry& entry) {
    return entry.name == "kind" &&
           (entry.value == "line" || entry.value == "roller_race" || entry.value == "gear_mesh");
  });
  entries.push_back({"grid", "cells",
                     pick<std::string>(random, line ? std::vector<std::string>{"128", "256"}
                                                    : std::vector<std::string>{"32", "48", "64"})});
  if (any([](const Entry& entry) { return entry.section == "subsurface"; }))
    entries.push_back({"subsurface", "planes", std::to_string(whole(random, 3, 6))});
  for (Entry& entry : entries)
    if (is(entry, "transient", "end_time")) entry.value = scaled(entry.value, random.between(0.02, 0.1));
}

}  // namespace

void take_input(std::vector<Entry>& entries, std::vector<File>& files, Random random, double share, bool& ordinary) {
  if (!random.chance(share)) return;
  ordinary = false;
  static const std::vector<fs::path> decks = decks_below(EHL_INPUTS);
  const fs::path deck = pick(random, decks);
  entries = entries_of(content_of(deck));
  files.clear();
  for (Entry& entry : entries)
    if (entry.value.ends_with(".csv") && fs::exists(deck.parent_path() / entry.value))
      files.push_back({entry.value, content_of(deck.parent_path() / entry.value)});
    else if (random.chance(0.5))
      entry.value = scaled(entry.value, log_between(random, 0.8, 1.25));
  make_small(entries, random);
  if (random.chance(0.3)) entries.push_back({"output", "checkpoint", "0.001"});
}

}  // namespace hard
