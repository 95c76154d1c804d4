// Rules between keys: keys without effect, keys that exclude each other, keys that are missing.
#include <algorithm>

#include "deck/deck.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

// "[thermal]", "[shear] flow = on": what the condition of a key asks for.
std::string described(const Key& key, const Condition& needs) {
  std::string text = needs.section.empty() || needs.section == key.section ? "" : "[" + needs.section + "]";
  if (!text.empty() && !needs.name.empty()) text += " ";
  return text + needs.name + (needs.words.empty() ? "" : " = " + joined(needs.words, " or "));
}

// A key without effect is an error, because the user expects one: "z" with a Barus fluid.
void check_influence_of(Deck& deck, const Key& key) {
  if (!given(deck, key.section, key.name) || has_influence(deck, key)) return;
  const auto nothing_without = [&](const std::string& what) {
    complain(deck, key.section, key.name, "has no influence without " + what + ": give that too, or remove it",
             Cause::idle);
  };
  if (!called_for(deck, key.section)) {
    nothing_without(joined(find_section(deck.catalogue, key.section)->called_by, " or "));
    return;
  }
  if (!key.needs.or_else.empty()) {
    std::string all = described(key, key.needs);
    for (const Condition& other : key.needs.or_else) all += " or " + described(key, other);
    nothing_without(all);
    return;
  }
  const std::string& section = section_needed(key);
  const std::string name = (section == key.section ? "" : "[" + section + "] ") + key.needs.name;
  const Value& other = value(deck, section, key.needs.name);
  if (key.needs.words.empty())
    nothing_without(name);
  else if (other.valid)
    complain(deck, key.section, key.name,
             "has no influence with " + name + " = " + other.text + ": remove it, or set " + name + " = " +
                 joined(key.needs.words, " or "),
             Cause::idle);
}

// Reports a key that is given together with one that it replaces; of the two, the one on the command line.
void check_alone(Deck& deck, const Key& key) {
  if (key.instead_of.empty() || !given(deck, key.section, key.name)) return;
  for (const std::string& other : key.instead_of) {
    if (!given(deck, key.section, other)) continue;
    const bool changed = value(deck, key.section, other).place == on_command_line;
    return complain(deck, key.section, changed ? other : key.name,
                    (changed ? key.name : other) + " is given as well: keep one of them");
  }
}

}  // namespace

void check_required(Deck& deck, const Key& key) {
  if (key.required.empty() || given(deck, key.section, key.name) || !has_influence(deck, key)) return;
  const auto is_given = [&](const std::string& name) { return given(deck, key.section, name); };
  if (!key.together.empty() &&
      (std::ranges::none_of(key.together, is_given) || std::ranges::any_of(key.instead_of, is_given)))
    return;
  for (const Key& other : deck.catalogue.keys)
    if (other.section == key.section && std::ranges::find(other.instead_of, key.name) != other.instead_of.end() &&
        is_given(other.name))
      return;
  complain(deck, key.section, key.name, "is missing: " + key.required, Cause::missing);
}

void check_influence(Deck& deck) {
  for (const Key& key : deck.catalogue.keys) {
    check_influence_of(deck, key);
    check_alone(deck, key);
  }
}

}  // namespace ehl::deck
