#pragma once
// One call of key() declares a key of the deck and, if it names one, the member of a struct that takes its value:
//
//   key("cells", &Grid::cells, Range{16, 4096}, own_default, "Number of cells along x.")
//
// What follows the member may stand in any order: a range, the attributes below, and the meaning as a plain text.
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "deck/deck.hpp"
#include "deck/text.hpp"

namespace ehl::deck {

/// A key, and what writes its value into a struct; the latter is empty if the module reads the key itself.
template <class S>
struct Record {
  Key key{};
  std::function<void(const Part& part, S& values)> take{};
  Record(Key plain) : key(std::move(plain)) {}
  Record(Key plain, std::function<void(const Part&, S&)> taken) : key(std::move(plain)), take(std::move(taken)) {}
};

template <class S>
using Records = std::vector<Record<S>>;

/// The words of a key and the values that they stand for.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;
inline const Choices<bool> on_off{{"on", true}, {"off", false}};

namespace record {

using deck::Range;

/// One text of a key, by the name of its member in Key.
template <std::string Key::*member>
struct Said {
  std::string text{};
};
inline Said<&Key::unit> unit(std::string text) { return {std::move(text)}; }
inline Said<&Key::default_text> by_default(std::string text) { return {std::move(text)}; }
inline Said<&Key::default_note> otherwise(std::string text) { return {std::move(text)}; }
inline Said<&Key::remedy> remedy(std::string text) { return {std::move(text)}; }
inline Said<&Key::source> source(std::string text) { return {std::move(text)}; }
inline Said<&Key::example> example(std::string text) { return {std::move(text)}; }
inline Said<&Key::required> required(std::string why) { return {std::move(why)}; }

/// The default is that of the struct.
struct OwnDefault {};
inline constexpr OwnDefault own_default{};
/// The example of the generated deck is not commented out.
struct Active {};
inline constexpr Active active{};
struct Words {
  std::vector<std::string> list{};
};
inline Words words(std::vector<std::string> list) { return {std::move(list)}; }
/// The key excludes these, of which one may be given instead.
struct InsteadOf {
  std::vector<std::string> names{};
};
inline InsteadOf instead_of(std::vector<std::string> names) { return {std::move(names)}; }

/// The deck gives this key with the others or without them, never alone.
struct Together {
  std::vector<std::string> names{};
  std::string why{};
};
inline Together together(std::vector<std::string> others, std::string why) {
  return {std::move(others), std::move(why)};
}

inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true, true};
inline constexpr Range not_negative{0.0, std::numeric_limits<double>::infinity(), false, true};
/// Positive, at most `most`.
inline constexpr Range up_to(double most) { return {0.0, most, true, false}; }
inline constexpr Range even(double least, double most) { return {least, most, false, false, Parity::even}; }
inline constexpr Range odd(double least, double most) { return {least, most, false, false, Parity::odd}; }
/// The key has an effect only with another one of its section: with any value, or with one of these words.
inline Condition needs(std::string name, std::vector<std::string> words = {}) {
  return {.name = std::move(name), .words = std::move(words)};
}
/// Adds the key of this quantity in SI.
inline Twin in_SI(std::string suffix, std::string unit, std::string example) {
  return {std::move(suffix), std::move(unit), std::move(example)};
}
inline Twin in_SI(std::string suffix, std::string unit, std::string example, Range range) {
  return {std::move(suffix), std::move(unit), std::move(example), range};
}
inline constexpr Type integer = Type::integer, text = Type::text;
inline constexpr Names file = Names::file;

template <std::string Key::*member>
void set(Key& key, Said<member> said) {
  key.*member = std::move(said.text);
}
inline void set(Key& key, std::string meaning) { key.meaning = std::move(meaning); }
inline void set(Key& key, const Range& range) { key.range = range; }
inline void set(Key& key, Type type) { key.type = type; }
inline void set(Key& key, Condition needs) { key.needs = std::move(needs); }
inline void set(Key& key, Words words) { key.words = std::move(words.list); }
inline void set(Key& key, InsteadOf other) { key.instead_of = std::move(other.names); }
inline void set(Key& key, Twin twin) { key.twin = std::move(twin); }
inline void set(Key& key, Together others) {
  key.together = std::move(others.names);
  key.required = std::move(others.why);
}
inline void set(Key&, OwnDefault) {}  // bind() knows the struct
inline void set(Key& key, Active) { key.example_is_active = true; }
inline void set(Key& key, Names names) {
  key.names = names;
  key.type = Type::text;
}

/// A key that the module reads itself.
template <class... Attributes>
Key key(std::string name, Attributes... attributes) {
  Key made{.name = std::move(name)};
  (set(made, std::move(attributes)), ...);
  return made;
}

template <class T>
struct Held {
  using type = T;
};
template <class T>
struct Held<std::optional<T>> {
  using type = T;
};

// The value of a key; one that is absent leaves `to` as it is.
template <class T>
void take_value(const Part& part, const std::string& name, const Choices<T>& choices, T& to) {
  if constexpr (std::is_same_v<T, double>) {
    const double found = part.number(name);
    if (part.has(name)) to = found;
  } else if constexpr (std::is_same_v<T, int>) {
    to = part.integer(name, to);
  } else if constexpr (std::is_same_v<T, std::string>) {
    to = part.word(name);
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    to = part.words(name);
  } else {
    const std::size_t k = index_of_word(part.deck, part.section, name);
    if (part.has(name)) to = choices[k].second;
  }
}

template <class T>
std::string text_of(const T& value, const Choices<T>& choices) {
  if constexpr (std::is_same_v<T, double>) return shortest(value);
  if constexpr (std::is_same_v<T, int>) return std::to_string(value);
  for (const auto& [word, stands_for] : choices)
    if (stands_for == value) return word;
  return {};
}

template <class T>
constexpr Type type_of() {
  if (std::is_same_v<T, int>) return Type::integer;
  if (std::is_same_v<T, std::string>) return Type::text;
  return std::is_same_v<T, std::vector<std::string>> ? Type::words : Type::number;
}

template <class S, class M, class T = typename Held<M>::type>
Record<S> bind(Key key, M S::*member, Choices<T> choices, bool defaults_to_member) {
  for (const auto& [word, value] : choices) key.words.push_back(word);
  if (key.type == Type::number && (key.words.empty() || !std::is_same_v<T, std::string>)) key.type = type_of<T>();
  if constexpr (std::is_same_v<M, T>)
    if (defaults_to_member) key.default_text = text_of<T>(S{}.*member, choices);
  const std::string name = key.name;
  return {std::move(key), [=](const Part& part, S& values) {
            if constexpr (std::is_same_v<M, T>) {
              take_value(part, name, choices, values.*member);
            } else {
              T found{};
              take_value(part, name, choices, found);
              if (part.given(name)) values.*member = found;
            }
          }};
}

/// A key whose value goes into a member of S: a number, a whole number, a text, words, or what a word stands for. An
/// optional member gets a value only if the deck gives the key.
template <class S, class M, class... Attributes>
Record<S> key(std::string name, M S::*member, Attributes... attributes) {
  return bind<S, M>(key(std::move(name), std::move(attributes)...), member, {},
                    (std::is_same_v<Attributes, OwnDefault> || ...));
}
template <class S, class M, class... Attributes>
Record<S> key(std::string name, M S::*member, Choices<typename Held<M>::type> choices, Attributes... attributes) {
  return bind<S, M>(key(std::move(name), std::move(attributes)...), member, std::move(choices),
                    (std::is_same_v<Attributes, OwnDefault> || ...));
}

}  // namespace record

/// The keys of records, as a section of the catalogue.
template <class S>
std::vector<Key> keys_of(const std::string& section, const Records<S>& records) {
  std::vector<Key> keys;
  for (const Record<S>& record : records) keys.push_back(record.key);
  return in_section(section, std::move(keys));
}

/// Makes the records depend on `other`, as only_with() of keys does.
template <class S>
Records<S> only_with(const Condition& other, Records<S> records) {
  for (Record<S>& record : records)
    if (record.key.needs.name.empty() && record.key.name != other.name) record.key.needs = other;
  return records;
}

/// Reports the keys of the section that are required and missing.
inline void check_required(const Part& part) {
  for (const Key& key : part.deck.catalogue.keys)
    if (key.section == part.section) check_required(part.deck, key);
}

/// Reports the required keys that are missing, and writes the value of every key into its member.
template <class S>
void read(const Part& part, const Records<S>& records, S& values) {
  for (const Record<S>& record : records) {
    check_required(part.deck, part.key(record.key.name));
    if (record.take) record.take(part, values);
  }
}
template <class S>
S read(const Part& part, const Records<S>& records) {
  S values{};
  read(part, records, values);
  return values;
}

}  // namespace ehl::deck
