// Writes a deck and its numbers as text with a random layout, and reads the list of keys that the program prints.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "hard/random_deck.hpp"

namespace hard {
namespace {

std::string blanks(Random& random) { return pick<std::string>(random, {"", " ", " ", "  ", "\t"}); }

std::string comment(Random& random) {
  return pick<std::string>(random, {"# a remark", "; = [x] remark", "#", "# [contact]", "# M = 3 µ", ""});
}

void swap_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

int whole(Random& random, int low, int high) {
  return std::min(high, low + static_cast<int>(random.between(0.0, 1.0 + high - low)));
}

double log_between(Random& random, double low, double high) {
  return std::exp(random.between(std::log(low), std::log(high)));
}

std::string written(Random& random, double value) {
  char buffer[40];
  const int digits = random.chance(0.7) ? whole(random, 4, 6) : whole(random, 7, 9);
  std::snprintf(buffer, sizeof buffer, random.chance(0.8) ? "%.*g" : "%.*e", digits, value);
  return buffer;
}

std::vector<KnownKey> read_known_keys(const std::string& listing) {
  std::vector<KnownKey> keys;
  std::string section;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) section = line.substr(1, line.find(']') - 1);
    if (line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
      keys.push_back({section, line.substr(2, line.find(' ', 2) - 2)});
  }
  return keys;
}

std::string deck_text(const std::vector<Entry>& entries, Random& random) {
  const bool plain = random.chance(0.5);
  std::string text;
  std::string section;
  for (const Entry& entry : entries) {
    if (entry.section != section || (!plain && random.chance(0.05))) text += "[" + entry.section + "]\n";
    section = entry.section;
    if (plain) {
      text += entry.name + " = " + entry.value + "\n";
      continue;
    }
    // One random number per statement: within one expression the compiler chooses the order.
    if (random.chance(0.2)) {
      text += blanks(random);
      text += comment(random) + "\n";
    }
    text += blanks(random);
    text += entry.name;
    text += blanks(random) + "=";
    text += blanks(random);
    text += entry.value;
    if (random.chance(0.2)) text += " # " + comment(random);
    text += blanks(random) + "\n";
  }
  if (random.chance(0.1)) swap_all(text, "\n", "\r\n");
  if (random.chance(0.05)) text.insert(0, "\xEF\xBB\xBF");
  if (random.chance(0.1)) text.erase(text.find_last_not_of("\r\n") + 1);
  return text;
}

}  // namespace hard
