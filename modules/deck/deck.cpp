#include "deck/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

std::size_t index_of(const Deck& deck, const std::string& section, const std::string& name) {
  const Key* key = find_key(deck.catalogue, section, name);
  if (key == nullptr) throw std::logic_error("deck: no module declares [" + section + "] " + name);
  return static_cast<std::size_t>(key - deck.catalogue.keys.data());
}

Value& value_of(Deck& deck, const std::string& section, const std::string& name) {
  return deck.values[index_of(deck, section, name)];
}

// Origin of a computed value in messages: changes on the command line, else the whole section.
std::string origin_of(const Deck& deck, const std::string& section) {
  std::vector<std::string> changed;
  for (std::size_t k = 0; k < deck.values.size(); ++k)
    if (deck.catalogue.keys[k].section == section && deck.values[k].place == on_command_line)
      changed.push_back(deck.catalogue.keys[k].name + " = " + quotable(deck.values[k].text));
  if (!changed.empty()) return std::string(on_command_line) + ": [" + section + "] " + joined(changed, ", ") + ": ";
  const auto heading = std::ranges::find(deck.headings, section, &Heading::section);
  return (heading == deck.headings.end() ? deck.name : heading->place) + ": [" + section + "]: ";
}

}  // namespace

Deck read(const std::string& path, const std::vector<std::string>& overrides, const Catalogue& catalogue) {
  return read_text(load_text(path), path, overrides, catalogue);
}

Deck read_text(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
               const Catalogue& catalogue) {
  const Document document = parse(text, path);
  std::vector<Assignment> assignments;
  for (const std::string& one : overrides) assignments.push_back(parse_override(one));
  Deck deck = validate(document, assignments, catalogue);
  deck.folders = {std::filesystem::absolute(path).parent_path().string()};
  return deck;
}

const Value& value(const Deck& deck, const std::string& section, const std::string& name) {
  return deck.values[index_of(deck, section, name)];
}

bool given(const Deck& deck, const std::string& section, const std::string& name) {
  const Value& found = value(deck, section, name);
  return found.origin == Origin::given || !found.from.empty();
}

bool called_for(const Deck& deck, const std::string& section) {
  const Section* record = find_section(deck.catalogue, section);
  return record == nullptr || record->called_by.empty() ||
         std::ranges::any_of(record->called_by, [&](const auto& name) { return given(deck, section, name); });
}

namespace {

bool holds(const Deck& deck, const Key& key, const Condition& needs) {
  const std::string& section = needs.section.empty() ? key.section : needs.section;
  if (needs.name.empty()) return called_for(deck, section);
  if (needs.words.empty()) return given(deck, section, needs.name);
  return std::ranges::find(needs.words, value(deck, section, needs.name).text) != needs.words.end();
}

}  // namespace

bool has_influence(const Deck& deck, const Key& key) {
  return called_for(deck, key.section) &&
         (holds(deck, key, key.needs) ||
          std::ranges::any_of(key.needs.or_else, [&](const Condition& other) { return holds(deck, key, other); }));
}

double number(const Deck& deck, const std::string& section, const std::string& name) {
  const Value& found = value(deck, section, name);
  found.read = true;
  const bool usable = found.origin != Origin::absent && found.valid;
  return usable ? found.number : std::numeric_limits<double>::quiet_NaN();
}

double number_in(Deck& deck, const std::string& section, const std::string& name, const PlainUnit& unit) {
  const std::string in_SI = name + unit.suffix;
  const double number = deck::number(deck, section, name);
  const double number_in_SI = deck::number(deck, section, in_SI);
  const bool plain = given(deck, section, name);
  const bool SI = given(deck, section, in_SI);
  if (SI && !plain && !unit.known)
    complain(deck, section, in_SI, "is in SI, but the contact is not given in SI: use " + name);
  if (plain || !SI) return number;
  // Otherwise the effective deck would show the default next to the number given instead.
  if (value(deck, section, name).origin == Origin::by_default) {
    choose(deck, section, name, number_in_SI / unit.in_SI, in_SI);
    mark_following(deck, section, name);
  }
  return number_in_SI / unit.in_SI;
}

int integer(const Deck& deck, const std::string& section, const std::string& name, int otherwise) {
  const double found = number(deck, section, name);
  return std::isnan(found) ? otherwise : static_cast<int>(found);
}

std::string word(const Deck& deck, const std::string& section, const std::string& name) {
  const Value& found = value(deck, section, name);
  found.read = true;
  return found.valid ? found.text : "";
}

std::vector<std::string> words(const Deck& deck, const std::string& section, const std::string& name) {
  return split_words(word(deck, section, name));
}

std::size_t index_of_word(const Deck& deck, const std::string& section, const std::string& name) {
  const std::vector<std::string>& legal = find_key(deck.catalogue, section, name)->words;
  const auto found = std::ranges::find(legal, word(deck, section, name));
  return found == legal.end() ? 0 : static_cast<std::size_t>(found - legal.begin());
}

void choose(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& why) {
  choose(deck, section, name, shortest(number), why);
  value_of(deck, section, name).number = number;
}

void choose(Deck& deck, const std::string& section, const std::string& name, const std::string& text,
            const std::string& why) {
  Value& chosen = value_of(deck, section, name);
  chosen = {.origin = Origin::chosen,
            .text = text,
            .number = std::numeric_limits<double>::quiet_NaN(),
            .why = why,
            .read = chosen.read};
}

void mark_following(Deck& deck, const std::string& section, const std::string& name) {
  Value& value = value_of(deck, section, name);
  value.follows = value.origin == Origin::chosen;
}

void compute(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& from,
             const std::string& why) {
  choose(deck, section, name, number, "[" + from + "]: " + why);
  mark_following(deck, section, name);
  Value& computed = value_of(deck, section, name);
  computed.from = from;
  computed.valid = !std::isnan(number);
}

void compute(Deck& deck, const std::string& section, const std::string& name, const char* word, const std::string& from,
             const std::string& why) {
  choose(deck, section, name, std::string(word), "[" + from + "]: " + why);
  mark_following(deck, section, name);
  value_of(deck, section, name).from = from;
}

void complain(Deck& deck, const std::string& section, const std::string& name, const std::string& what, Cause cause) {
  const Value& found = value(deck, section, name);
  if (!found.from.empty() && !deck.errors.empty()) return;  // most likely a consequence of that error
  if (!found.from.empty()) {
    const std::string text = std::isnan(found.number) ? found.text : fmt::format("{:.6g}", found.number);
    add_error(
        deck, cause,
        origin_of(deck, found.from) + "so [" + section + "] " + name + " = " + text + " (" + found.why + "): " + what);
    return;
  }
  const std::string place = found.place.empty() ? deck.name : found.place;
  const std::string assignment = found.origin == Origin::given ? name + " = " + quotable(found.text) : name;
  add_error(deck, cause, place + ": [" + section + "] " + assignment + ": " + what);
}

void add_error(Deck& deck, Cause cause, const std::string& text) {
  deck.errors.push_back(text);
  deck.causes.push_back(cause);
}

std::vector<std::string> first_causes(const Deck& deck) {
  const std::vector<Cause>& causes = deck.causes;
  const bool by_itself = std::ranges::find(causes, Cause::by_itself) != causes.end();
  std::vector<std::string> errors;
  for (std::size_t k = 0; k < causes.size(); ++k)
    if (!by_itself || (causes[k] != Cause::missing && causes[k] != Cause::idle)) errors.push_back(deck.errors[k]);
  return errors;
}

void throw_if_wrong(const Deck& deck) {
  if (!deck.errors.empty()) throw core::InputError(first_causes(deck));
}

std::vector<std::string> Part::given_of(const std::vector<std::string>& names) const {
  std::vector<std::string> found;
  std::ranges::copy_if(names, std::back_inserter(found), [&](const std::string& name) { return given(name); });
  return found;
}

void Part::demand(const std::vector<std::string>& names, const std::string& why) const {
  for (const std::string& name : names)
    if (!given(name)) complain(name, "is missing: " + why, Cause::missing);
}

void Part::refuse(const std::vector<std::string>& names, const std::string& why, Cause cause) const {
  for (const std::string& name : given_of(names)) complain(name, why, cause);
}

}  // namespace ehl::deck
