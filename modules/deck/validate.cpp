// Checks of single keys: known, given once, readable, in range.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "deck/deck.hpp"
#include "deck/text.hpp"

namespace ehl::deck {
namespace {

std::vector<std::string> names_in(const Catalogue& catalogue, const std::string& section) {
  std::vector<std::string> names;
  for (const Key& key : catalogue.keys)
    if (key.section == section) names.push_back(key.name);
  return names;
}

std::vector<std::string> section_names(const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const Section& section : catalogue.sections) names.push_back(section.name);
  return names;
}

const Unavailable* find_unavailable(const Catalogue& catalogue, const std::string& section, const std::string& name) {
  for (const Unavailable& entry : catalogue.unavailable)
    if (entry.section == section && entry.name == name && entry.words.empty()) return &entry;
  return nullptr;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = nearest(name, candidates);
  return near.empty() ? "" : "did you mean " + near + "? ";
}

// An unknown name and what may be meant; a sentence follows.
std::string unknown_name(const std::string& what, const std::string& hint) {
  return what + (hint.empty() ? ". " : ": " + hint);
}

std::string bracketed(const std::string& section) { return std::string("[").append(quotable(section)).append("]"); }

std::string said(const Assignment& given) {
  if (given.removes) return given.place + ": --unset " + quotable(given.section + "." + given.name) + ": ";
  const std::string section = given.section.empty() ? "" : bracketed(given.section) + " ";
  return given.place + ": " + section + quotable(given.name) + " = " + quotable(given.value) + ": ";
}

std::string unknown_section(const Catalogue& catalogue, const std::string& name) {
  if (const Unavailable* unavailable = find_unavailable(catalogue, name, "")) return unavailable->message;
  const std::vector<std::string> sections = section_names(catalogue);
  std::vector<std::string> shown;
  for (const Section& section : catalogue.sections)
    if (!section.on_request) shown.push_back(section.name);
  return unknown_name("unknown section", did_you_mean(name, sections)) + "Sections are " + joined(shown, ", ");
}

constexpr std::size_t most_of_a_kind = 20;  // number of errors of one kind that are listed

/// Errors of one kind; the first ones are listed and the rest counted.
class Kind {
 public:
  Kind(Deck& deck, Cause cause, std::string what) : deck_(deck), cause_(cause), what_(std::move(what)) {}
  ~Kind() {
    if (count_ > most_of_a_kind)
      add_error(deck_, cause_, deck_.name + ": " + std::to_string(count_ - most_of_a_kind) + " more " + what_);
  }
  Kind(const Kind&) = delete;
  Kind& operator=(const Kind&) = delete;

  template <class Say>
  void add(const Say& say) {
    if (++count_ <= most_of_a_kind) add_error(deck_, cause_, say());
  }

 private:
  Deck& deck_;
  Cause cause_;
  std::string what_;
  std::size_t count_ = 0;
};

void check_headings(Deck& deck, const Document& document) {
  Kind unknown{deck, Cause::by_itself, "unknown sections"}, empty{deck, Cause::idle, "sections without a key"};
  std::set<std::string> with_keys;
  for (const Assignment& given : document.assignments) with_keys.insert(given.section);
  for (const Heading& heading : document.headings) {
    const auto where = [&] { return heading.place + ": " + bracketed(heading.section) + ": "; };
    const Section* section = find_section(deck.catalogue, heading.section);
    if (section == nullptr) {
      unknown.add([&] { return where() + unknown_section(deck.catalogue, heading.section); });
      continue;
    }
    if (with_keys.contains(heading.section)) continue;
    const std::vector<std::string>& callers = section->called_by;
    empty.add([&] {
      return where() + "a section without a key has no influence: remove it, or give " +
             (section->on_request ? "one of those that `ehl keys " + heading.section + "` lists"
              : callers.empty()   ? "one of " + joined(names_in(deck.catalogue, heading.section), ", ")
                                  : joined(callers, " or "));
    });
  }
}

// Message about an unknown key.
std::string about_unknown(const Deck& deck, const Assignment& given) {
  if (const Unavailable* unavailable = find_unavailable(deck.catalogue, given.section, given.name))
    return said(given) + unavailable->message;
  std::string home;  // a section that has a key of this name
  for (const Key& key : deck.catalogue.keys)
    if (key.name == given.name) home = key.section;
  if (given.section.empty())
    return said(given) + "a key before the first [section]" + (home.empty() ? "" : ": it belongs below [" + home + "]");
  if (const Section* section = find_section(deck.catalogue, given.section)) {
    const std::vector<std::string> names = names_in(deck.catalogue, given.section);
    const std::string hint = home.empty() ? did_you_mean(given.name, names) : "it belongs below [" + home + "]. ";
    const std::string list = section->on_request ? "`ehl keys " + given.section + "` lists the keys"
                                                 : "Keys of [" + given.section + "] are " + joined(names, ", ");
    return said(given) + unknown_name("unknown key", hint) + list;
  }
  return said(given) + unknown_section(deck.catalogue, given.section);
}

Value untouched(const Key& key) {
  return {.origin = key.default_text.empty() ? Origin::absent : Origin::by_default,
          .text = key.default_text,
          .number = read_number(key.default_text).value};
}

// Assigns all values to their keys.
void take(Deck& deck, const std::vector<Assignment>& assignments) {
  Kind unknown{deck, Cause::by_itself, "unknown keys"}, twice{deck, Cause::between, "keys given twice"};
  Kind not_there{deck, Cause::between, "keys removed that the deck does not give"};
  for (const Assignment& given : assignments) {
    const Key* key = find_key(deck.catalogue, given.section, given.name);
    if (key == nullptr) {
      // A key below an unknown heading is not reported again.
      const bool heading_is_unknown =
          find_section(deck.catalogue, given.section) == nullptr &&
          std::ranges::find(deck.headings, given.section, &Heading::section) != deck.headings.end() &&
          find_unavailable(deck.catalogue, given.section, given.name) == nullptr;
      if (!heading_is_unknown) unknown.add([&] { return about_unknown(deck, given); });
      continue;
    }
    Value& value = deck.values[static_cast<std::size_t>(key - deck.catalogue.keys.data())];
    if (given.removes) {
      if (value.origin != Origin::given)
        not_there.add([&] { return said(given) + "cannot be removed: the deck does not give this key"; });
      value = untouched(*key);
      continue;
    }
    if (value.origin == Origin::given && (value.place == on_command_line) == (given.place == on_command_line)) {
      twice.add([&] {
        return said(given) + "given twice: the first time at " + value.place + " (= " + quotable(value.text) +
               "); remove one";
      });
      continue;
    }
    value.origin = Origin::given;
    value.text = given.value;
    value.place = given.place;
  }
}

std::string complaint_about_number(const Key& key, const Value& value, double& number) {
  const ReadNumber read = read_number(value.text);
  const std::string must = "must be " + allowed(key);
  const std::string unit = key.unit.empty() ? "it has no unit" : "the unit is " + key.unit;
  switch (read.status) {
    case ReadNumber::Status::number: break;
    case ReadNumber::Status::not_finite: return "not a finite number: " + must;
    case ReadNumber::Status::out_of_reach: return "outside the range of floating-point numbers: " + must;
    case ReadNumber::Status::trailing_text:
      if (read.trailing[0] == ',') return "write a decimal point, not a comma: " + must;
      return "write the number alone, without " + quoted(read.trailing) + ": " + unit + ". It " + must;
    case ReadNumber::Status::not_a_number: return "this is not a number: " + must;
  }
  if (key.type == Type::integer && (read.value != std::floor(read.value) || std::abs(read.value) > 2e9)) return must;
  if (key.range.parity != Parity::any && (std::fmod(read.value, 2.0) != 0.0) != (key.range.parity == Parity::odd))
    return must + (key.remedy.empty() ? "" : ": " + key.remedy);
  if (!key.range.contains(read.value)) return must + (key.remedy.empty() ? "" : ": " + key.remedy);
  number = read.value;
  return "";
}

std::string complaint_about_words(const Catalogue& catalogue, const Key& key, const std::vector<std::string>& given) {
  for (const std::string& word : given) {
    if (std::ranges::find(key.words, word) != key.words.end()) continue;
    for (const Unavailable& entry : catalogue.unavailable)
      if (entry.section == key.section && entry.name == key.name &&
          std::ranges::find(entry.words, word) != entry.words.end())
        return entry.message;
    return quoted(word) + " is unknown: " + did_you_mean(word, key.words) + "must be " + allowed(key);
  }
  return "";
}

void check_value(Deck& deck, const Key& key, Value& value) {
  std::string complaint;
  value.number = std::numeric_limits<double>::quiet_NaN();
  if (value.text.empty()) {
    complaint = "the value is missing: it must be " + allowed(key);
  } else if (key.type == Type::number || key.type == Type::integer) {
    complaint = complaint_about_number(key, value, value.number);
  } else if (key.type == Type::word) {
    complaint = complaint_about_words(deck.catalogue, key, {value.text});
  } else if (key.type == Type::words) {
    complaint = complaint_about_words(deck.catalogue, key, split_words(value.text));
  } else if (std::any_of(value.text.begin(), value.text.end(), [](unsigned char c) { return c < ' '; })) {
    complaint = "must be text on one line";  // otherwise the deck stored in the result would read differently
  } else if (!is_utf8(value.text)) {
    complaint = "must be text in UTF-8: save the deck in that encoding";
  }
  if (complaint.empty()) return;
  complain(deck, key.section, key.name, complaint, Cause::by_itself);
  value.valid = false;
}

}  // namespace

Deck validate(const Document& document, const std::vector<Assignment>& overrides, const Catalogue& catalogue) {
  Deck deck;
  deck.name = document.name;
  deck.catalogue = catalogue;
  deck.headings = document.headings;
  for (const std::string& error : document.errors) add_error(deck, Cause::by_itself, error);
  for (const Key& key : catalogue.keys) deck.values.push_back(untouched(key));

  check_headings(deck, document);
  take(deck, document.assignments);
  take(deck, overrides);

  for (std::size_t k = 0; k < catalogue.keys.size(); ++k)
    if (deck.values[k].origin == Origin::given) check_value(deck, catalogue.keys[k], deck.values[k]);
  return deck;
}

}  // namespace ehl::deck
