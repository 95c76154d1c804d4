#include "deck/write.hpp"

#include <algorithm>
#include <sstream>

#include "core/errors.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

// Breaks a text into lines of about 110 characters, each beginning with `indent`.
std::string wrapped(const std::string& text, const std::string& indent) {
  constexpr std::size_t width = 110;
  std::string result;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && indent.size() + line.size() + word.size() + 1 > width) {
      result += indent + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? result : result + indent + line + "\n";
}

std::string with_unit(const Key& key) { return key.unit.empty() ? key.name : key.name + " [" + key.unit + "]"; }

std::string default_of(const Key& key) {
  if (!key.default_text.empty()) return key.default_text;
  return key.default_note.empty() ? "none" : key.default_note;
}

std::string condition_of(const Key& key) {
  if (key.needs.name.empty()) return "";
  const std::string section = key.needs.section.empty() ? "" : "[" + key.needs.section + "] ";
  return "only with " + section + key.needs.name +
         (key.needs.words.empty() ? "" : " = " + joined(key.needs.words, " or "));
}

std::string description(const Key& key) {
  const std::string condition = condition_of(key);
  std::string text = key.meaning;
  if (!condition.empty()) text += " (" + condition + ")";
  return text;
}

std::string entry(const Key& key) {
  std::string text = "  " + with_unit(key) + "\n";
  text += wrapped(description(key), "      ");
  text += wrapped("default: " + default_of(key), "      ");
  text += wrapped("allowed: " + allowed(key), "      ");
  if (!key.source.empty()) text += wrapped("source:  " + key.source, "      ");
  return text;
}

// A line of the generated deck is active if it has the example, or a default that is allowed there.
bool active_in_example(const Catalogue& catalogue, const Key& key) {
  if (key.example_is_active) return true;
  if (key.default_text.empty()) return false;
  const Section* section = find_section(catalogue, key.section);
  if (section != nullptr && !section->called_by.empty()) return false;  // no effect is enabled in the example
  if (key.needs.name.empty()) return true;
  const Key* other = find_key(catalogue, section_needed(key), key.needs.name);
  if (other == nullptr || key.needs.words.empty()) return false;
  const std::string text = other->example_is_active ? other->example : other->default_text;
  return std::find(key.needs.words.begin(), key.needs.words.end(), text) != key.needs.words.end();
}

// Description of a section, and for an effect what enables it.
std::string about(const Section& section) {
  if (section.effect.empty()) return section.meaning;
  return section.meaning + " Effect " + section.effect + ": enabled by " + joined(section.called_by, " or ") + ".";
}

std::string example_of(const Key& key) { return key.example.empty() ? key.default_text : key.example; }

void throw_unknown(const Catalogue& catalogue, const std::string& selection) {
  std::vector<std::string> names;
  for (const Section& section : catalogue.sections) names.push_back(section.name);
  for (const Key& key : catalogue.keys) names.push_back(key.section + "." + key.name);
  for (const Key& key : catalogue.keys)  // "cells" alone: the section was omitted
    if (key.name == selection)
      throw core::InputError("keys: " + selection + ": did you mean " + key.section + "." + key.name + "?");
  const std::string near = nearest(selection, names);
  throw core::InputError("keys: " + selection + ": there is no such section or key" +
                         (near.empty() ? "" : ": did you mean " + near + "?") + " (`ehl keys` lists all)");
}

}  // namespace

std::string list_keys(const Catalogue& catalogue, const std::string& selection) {
  std::string text;
  for (const Section& section : catalogue.sections) {
    if (section.on_request && selection.empty()) continue;
    std::string entries;
    for (const Key& key : catalogue.keys)
      if (key.section == section.name &&
          (selection.empty() || selection == section.name || selection == key.section + "." + key.name))
        entries += entry(key);
    if (!entries.empty()) text += (text.empty() ? "[" : "\n[") + section.name + "]  " + about(section) + "\n" + entries;
  }
  if (text.empty()) throw_unknown(catalogue, selection);
  return text;
}

std::string commented_deck(const Catalogue& catalogue) {
  std::string text =
      "# A complete deck: every key with its meaning. Lines that begin with '# ' before a key are alternatives,\n"
      "# or values that are chosen for the case if the line stays commented out. `ehl keys` explains more.\n";
  for (const Section& section : catalogue.sections) {
    if (section.on_request) continue;
    std::string lines;
    bool any_active = false;
    for (const Key& key : catalogue.keys) {
      if (key.section != section.name) continue;
      const bool active = active_in_example(catalogue, key);
      any_active = any_active || active;
      lines += wrapped(with_unit(key) + ": " + description(key), "# ");
      lines += wrapped("allowed: " + allowed(key) + "; default: " + default_of(key), "#   ");
      lines += (active ? "" : "# ") + key.name + " = " + example_of(key) + "\n";
    }
    const std::string heading = (any_active ? "[" : "# [") + section.name + "]\n";
    text += "\n";
    text += wrapped(about(section), "# ") + heading + lines;
  }
  return text;
}

std::string effective_deck(const Deck& deck) {
  std::string text;
  for (const Section& section : deck.catalogue.sections) {
    std::string lines;
    bool any_active = false;  // a heading followed only by comments would be refused
    for (std::size_t k = 0; k < deck.catalogue.keys.size(); ++k) {
      const Key& key = deck.catalogue.keys[k];
      const Value& value = deck.values[k];
      if (key.section != section.name || value.origin == Origin::absent) continue;
      // A default without effect would be refused when read again.
      if (value.origin == Origin::by_default && !has_influence(deck, key)) continue;
      any_active = any_active || !value.follows;
      lines += (value.follows ? "# " : "") + key.name + " = " + value.text;
      std::string note = key.unit;
      if (value.origin == Origin::by_default) note += std::string(note.empty() ? "" : ", ") + "default";
      if (value.origin == Origin::chosen)
        note += std::string(note.empty() ? "" : ", ") + (value.follows ? "follows: " : "chosen: ") + value.why;
      lines += (note.empty() ? "" : "  # " + note) + "\n";
    }
    if (!lines.empty())
      text += (text.empty() ? "" : "\n") + std::string(any_active ? "[" : "# [") + section.name + "]\n" + lines;
  }
  return text;
}

}  // namespace ehl::deck
