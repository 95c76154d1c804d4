#pragma once
// What a deck may say: one record per key, declared by the module that uses the key.
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace ehl::deck {

enum class Type { number, integer, word, words, text };

/// The allowed range of a number or integer; open ends exclude the bound itself.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;

  bool contains(double value) const {
    return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
  }
};

/// A key that means something only beside another one, of its own section where none is named: given at all (no words),
/// or one of these words.
struct Condition {
  std::string name{};
  std::vector<std::string> words{};
  std::string section{};
};

/// One key of the deck. Everything the program says about a key, anywhere, is said from this record.
struct Key {
  std::string section{};
  std::string name{};
  Type type = Type::number;
  std::string default_text{};        ///< the default as the deck would write it; empty: none
  std::string default_note{};        ///< how a value is found when there is no fixed default
  std::string unit{};                ///< SI unit; empty: dimensionless or a word
  Range range{};                     ///< numbers and integers
  std::vector<std::string> words{};  ///< the legal words of Type::word and Type::words
  std::string remedy{};              ///< said when a value is outside the range
  std::string meaning{};
  std::string source{};  ///< where the default (or the meaning) comes from
  Condition needs{};
  std::string example{};           ///< what the self-written deck shows where there is no default
  bool names_file = false;         ///< a value that ends like a table or an HDF5 file is the name of one
  bool example_is_active = false;  ///< the self-written deck uses the example instead of commenting it out
};

/// A section of the deck. Of an effect: the section without one of the keys that call for the effect has no influence,
/// and is refused.
struct Section {
  std::string name{};
  std::string meaning{};
  std::vector<std::string> called_by{};  ///< keys of the section, one is enough; none: a section of every deck
  std::string effect{};                  ///< name of the effect that it belongs to; empty: of every deck
};

/// Something people will look for that this version cannot do: a whole section (empty name), a key, or a word of a key.
struct Unavailable {
  std::string section{};
  std::string name{};
  std::string message{};
  std::vector<std::string> words{};  ///< of a key that exists; empty: the key does not
};

/// Everything a deck may contain.
struct Catalogue {
  std::vector<Section> sections{};
  std::vector<Key> keys{};
  std::vector<Unavailable> unavailable{};
};

/// Keys of one section. Each with words is of Type::word, unless it says that it takes several of them.
std::vector<Key> in_section(const std::string& section, std::vector<Key> keys);

/// The same keys, each only with another one where it does not say itself what it needs; that one stays free.
std::vector<Key> only_with(const Condition& other, std::vector<Key> keys);

/// Lists of keys, one behind the other.
std::vector<Key> together(std::initializer_list<std::vector<Key>> lists);

/// The key for the same quantity in SI, "<name><suffix>": one of both is given (deck::number_in reads them).
Key in_SI(Key plain, const std::string& suffix, const std::string& unit, const std::string& example);

/// The record of a key, or nullptr.
const Key* find_key(const Catalogue& catalogue, const std::string& section, const std::string& name);

/// The record of a section, or nullptr.
const Section* find_section(const Catalogue& catalogue, const std::string& name);

/// The section of the key that `key` needs.
const std::string& section_needed(const Key& key);

/// "0 < value <= 1000 N", "one of V, W, F": what is allowed, for messages and for the list of keys.
std::string allowed(const Key& key);

}  // namespace ehl::deck
