#include "deck/key.hpp"

#include <algorithm>
#include <cmath>

#include "deck/text.hpp"

namespace ehl::deck {
namespace {

std::string allowed_range(const Key& key) {
  const std::string unit = key.unit.empty() ? "" : " " + key.unit;
  const std::string whole = key.range.parity == Parity::odd    ? "an odd number"
                            : key.range.parity == Parity::even ? "an even number"
                                                               : "a whole number";
  const std::string what = key.type == Type::integer ? whole : "a number";
  const bool below = std::isfinite(key.range.lower);
  const bool above = std::isfinite(key.range.upper);
  const std::string lower = (key.range.lower_open ? "> " : ">= ") + shortest(key.range.lower);
  const std::string upper = (key.range.upper_open ? "< " : "<= ") + shortest(key.range.upper);
  if (below && above) return what + " " + lower + " and " + upper + unit;
  if (below) return what + " " + lower + unit;
  if (above) return what + " " + upper + unit;
  return what + (key.unit.empty() ? "" : " in " + key.unit);
}

Key twin_of(const Key& plain) {
  Key twin = plain;
  twin.name += plain.twin.suffix;
  twin.unit = plain.twin.unit;
  twin.meaning = "Value of " + plain.name + " in " + twin.unit + ", for a contact in SI.";
  twin.default_text.clear();
  twin.example = plain.twin.example;
  if (!std::isnan(plain.twin.range.lower)) twin.range = plain.twin.range;
  twin.instead_of = {plain.name};
  twin.required.clear();
  twin.twin = {};
  return twin;
}

}  // namespace

std::vector<Key> in_section(const std::string& section, std::vector<Key> keys) {
  std::vector<Key> all;
  for (Key& key : keys) {
    const bool is_new = key.section.empty();
    key.section = section;
    if (!key.words.empty() && key.type == Type::number) key.type = Type::word;
    all.push_back(key);
    if (!key.twin.suffix.empty() && is_new) all.push_back(twin_of(key));
  }
  return all;
}

std::vector<Key> only_with(const Condition& other, std::vector<Key> keys) {
  for (Key& key : keys)
    if (key.needs.name.empty() && key.name != other.name) key.needs = other;
  return keys;
}

bool names_file(const Key& key, const std::string& value) {
  if (key.names != Names::file_or_list)
    return key.names == Names::file && std::ranges::find(key.words, value) == key.words.end();
  const std::string first = value.substr(0, value.find_first_of(": \t"));
  return read_number(first).status != ReadNumber::Status::number;
}

const Key* find_key(const Catalogue& catalogue, const std::string& section, const std::string& name) {
  for (const Key& key : catalogue.keys)
    if (key.section == section && key.name == name) return &key;
  return nullptr;
}

const Section* find_section(const Catalogue& catalogue, const std::string& name) {
  for (const Section& section : catalogue.sections)
    if (section.name == name) return &section;
  return nullptr;
}

const std::string& section_needed(const Key& key) {
  return key.needs.section.empty() ? key.section : key.needs.section;
}

std::string allowed(const Key& key) {
  switch (key.type) {
    case Type::number:
    case Type::integer: return allowed_range(key);
    case Type::word: return "one of " + joined(key.words, ", ");
    case Type::words: return "any of " + joined(key.words, ", ");
    case Type::text: break;
  }
  return "any text";
}

}  // namespace ehl::deck
