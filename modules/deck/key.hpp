#pragma once
// Keys of a deck: one record per key, declared by the module that uses it.
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace ehl::deck {

enum class Type { number, integer, word, words, text };

/// What the value of a key names: nothing; a file, whatever its ending, unless it is one of the words of the key; or a
/// file unless the value is a list, "1:1 2:0".
enum class Names { nothing, file, file_or_list };

/// Which whole numbers a key allows.
enum class Parity { any, odd, even };

/// The allowed range of a number or integer; open ends exclude the bound itself.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;
  Parity parity = Parity::any;

  bool contains(double value) const {
    return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
  }
};

/// A key has an effect only with another one, of the same section if none is named: with any value, or with one of
/// these words. Without a name: only if the effect of the section is enabled.
struct Condition {
  std::string name{};
  std::vector<std::string> words{};
  std::string section{};
  std::vector<Condition> or_else{};  ///< another condition that is enough
};

/// The key of the same quantity in SI, "<name><suffix>", for a contact in SI; a deck gives one of both
/// (deck::number_in()).
struct Twin {
  std::string suffix{};
  std::string unit{};
  std::string example{};
  Range range{.lower = std::numeric_limits<double>::quiet_NaN()};  ///< NaN: that of the plain key
};

/// One key of the deck. Everything that the program prints about a key comes from this record.
struct Key {
  std::string section{};
  std::string name{};
  Type type = Type::number;
  std::string default_text{};        ///< the default as written in a deck; empty: none
  std::string default_note{};        ///< how the value is determined without a fixed default
  std::string unit{};                ///< SI unit; empty: dimensionless or a word
  Range range{};                     ///< numbers and integers
  std::vector<std::string> words{};  ///< the allowed words of Type::word and Type::words
  std::string remedy{};              ///< advice for a value outside the range
  std::string meaning{};
  std::string source{};  ///< source of the default or of the meaning
  Condition needs{};
  std::string example{};           ///< value in the generated deck if there is no default
  Names names = Names::nothing;    ///< whether the value is the name of a file that the case reads
  bool example_is_active = false;  ///< the generated deck uses the example instead of commenting it out
  /// Keys of the section that must not be given together with this one: one of them replaces it.
  std::vector<std::string> instead_of{};
  /// Why the deck must give this key, or one that replaces it, if the module reads it and it has an effect; if it
  /// belongs `together` with other keys, only if one of them is given.
  std::string required{};
  std::vector<std::string> together{};
  Twin twin{};  ///< without a suffix: none
};

/// A section of the deck. The section of an effect is refused unless one of the keys that enable the effect is given.
struct Section {
  std::string name{};
  std::string meaning{};
  std::vector<std::string> called_by{};  ///< keys of the section that enable it, one is enough; none: every deck has it
  std::string effect{};                  ///< name of the effect; empty: every deck has the section
  bool on_request = false;               ///< listed only if it is asked for by name
};

/// A capability that this version lacks and users may look for: a section (empty name), a key, or a word of a key.
struct Unavailable {
  std::string section{};
  std::string name{};
  std::string message{};
  std::vector<std::string> words{};  ///< words of an existing key; empty: the key does not exist
};

/// Everything a deck may contain.
struct Catalogue {
  std::vector<Section> sections{};
  std::vector<Key> keys{};
  std::vector<Unavailable> unavailable{};
};

/// Adds the section to keys, and after each key its twin. A key with words becomes Type::word, unless it is
/// Type::words.
std::vector<Key> in_section(const std::string& section, std::vector<Key> keys);

/// Makes keys depend on `other`, except those that have their own condition and `other` itself.
std::vector<Key> only_with(const Condition& other, std::vector<Key> keys);

/// Concatenates lists of keys, or of records (record.hpp).
template <class Each>
std::vector<Each> together(std::initializer_list<std::vector<Each>> lists) {
  std::vector<Each> all;
  for (const std::vector<Each>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}
inline std::vector<Key> together(std::initializer_list<std::vector<Key>> lists) { return together<Key>(lists); }

/// True if this value of the key is the name of a file. A value of Names::file_or_list is a list if its first word, up
/// to a colon, is a number. A word that the key allows is no file.
bool names_file(const Key& key, const std::string& value);

/// The record of a key, or nullptr.
const Key* find_key(const Catalogue& catalogue, const std::string& section, const std::string& name);

/// The record of a section, or nullptr.
const Section* find_section(const Catalogue& catalogue, const std::string& name);

/// Section of the key that `key` needs.
const std::string& section_needed(const Key& key);

/// "0 < value <= 1000 N", "one of V, W, F": the allowed values, for messages and the list of keys.
std::string allowed(const Key& key);

}  // namespace ehl::deck
