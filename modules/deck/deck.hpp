#pragma once
// A deck that has been checked against the catalogue of keys: one value per key, and all errors.
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "deck/document.hpp"
#include "deck/key.hpp"

namespace ehl::deck {

/// Origin of a value; chosen: by the program, because the deck does not give the key.
enum class Origin { absent, by_default, given, chosen };

/// Value of a key.
struct Value {
  Origin origin = Origin::absent;
  bool valid = true;     ///< false: given, but an error has been reported
  std::string text{};    ///< as written
  double number = 0.0;   ///< of numbers and integers; NaN if absent or invalid
  std::string place{};   ///< where it was given
  std::string why{};     ///< reason of a chosen value
  bool follows = false;  ///< chosen, and computed from other keys at every reading
  std::string from{};    ///< section whose keys stand for this one, which then counts as given; usually empty
  /// True if the number or text has been read. A test requires that every declared key is read.
  mutable bool read = false;
};

/// Kind of an error, for first_causes(). by_itself: an unknown section, key or word, a value out of range, or a line
/// that cannot be read. between: a rule between keys. idle: a key without effect.
enum class Cause { by_itself, between, missing, idle };

/// A deck that has been read.
struct Deck {
  std::string name{};
  std::vector<std::string> folders{};  ///< where files named by the deck may lie, besides the current directory
  Catalogue catalogue{};
  std::vector<Value> values{};        ///< one per key of the catalogue
  std::vector<Heading> headings{};    ///< the sections of the deck
  std::vector<std::string> errors{};  ///< complete messages
  std::vector<Cause> causes{};        ///< one per error
};

/// Reads a deck and checks every key on its own: known, given once, readable, in range. Rules between keys are checked
/// by check_influence() and by the readers of the keys; they add to `errors` with complain(), and throw_if_wrong() ends
/// it.
/// in: path of the deck; overrides "section.key=value", or "-section.key", which removes the key. errors:
/// core::InputError if the file cannot be read.
Deck read(const std::string& path, const std::vector<std::string>& overrides, const Catalogue& catalogue);

/// Reads a deck from a text. in: path for messages; files named by the deck are looked for next to it.
Deck read_text(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
               const Catalogue& catalogue);

/// Checks a deck that has been parsed.
Deck validate(const Document& document, const std::vector<Assignment>& overrides, const Catalogue& catalogue);

/// The value of a key. errors: std::logic_error for a key that no module has declared.
const Value& value(const Deck& deck, const std::string& section, const std::string& name);

/// True if the deck or the command line gives the key, valid or not, or if it is computed from other keys.
bool given(const Deck& deck, const std::string& section, const std::string& name);

/// True if every deck has the section, or the deck gives a key that enables the effect of the section.
bool called_for(const Deck& deck, const std::string& section);

/// True if the key has an effect: its section is enabled, and the key that it needs is given.
bool has_influence(const Deck& deck, const Key& key);

/// Number of a key: given, chosen or default; NaN if there is none or it was refused.
double number(const Deck& deck, const std::string& section, const std::string& name);

/// Unit of a quantity that a deck gives either dimensionless, as `name`, or in SI, as name + suffix.
struct PlainUnit {
  std::string suffix{};
  double in_SI = std::numeric_limits<double>::quiet_NaN();
  bool known = false;  ///< the deck gives, correctly or not, the keys from which in_SI follows
};

/// Such a quantity, dimensionless. Reports an error if the SI form is given without a known unit; check_influence()
/// reports both forms together. The SI form replaces a default. out: NaN if neither is given or after an error.
double number_in(Deck& deck, const std::string& section, const std::string& name, const PlainUnit& unit);

/// number() for an integer. limits: `otherwise` if there is none or it was refused.
int integer(const Deck& deck, const std::string& section, const std::string& name, int otherwise);

/// Word or text of a key; empty if there is none or it was refused.
std::string word(const Deck& deck, const std::string& section, const std::string& name);

/// Words of a key.
std::vector<std::string> words(const Deck& deck, const std::string& section, const std::string& name);

/// Index of the given word among the words of the key; 0 if there is none or it was refused.
std::size_t index_of_word(const Deck& deck, const std::string& section, const std::string& name);

/// Records a value that the program has chosen for a key, for the effective deck and the report.
void choose(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& why);
void choose(Deck& deck, const std::string& section, const std::string& name, const std::string& text,
            const std::string& why);

/// Marks a value that is not given as one that follows from other keys. The effective deck shows it in a comment, so
/// that those other keys can be changed there.
void mark_following(Deck& deck, const std::string& section, const std::string& name);

/// Records a number that follows from keys of the section `from`, which stand for this one: it counts as given. in: NaN
/// after an error in those keys.
void compute(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& from,
             const std::string& why);
/// Records a word in this way; it must be one of those that the key allows.
void compute(Deck& deck, const std::string& section, const std::string& name, const char* word, const std::string& from,
             const std::string& why);

/// Reports every key that has no effect in this deck, and every key that is given together with one that it replaces.
/// To be called after all compute() calls.
void check_influence(Deck& deck);

/// Reports a key that is required, has an effect, and is missing; so are the keys that replace it.
void check_required(Deck& deck, const Key& key);

/// Adds the message "deck.ini:12: [grid] cells = 77: <what>". For a computed number the message begins with its origin:
/// the keys of that section on the command line, else the heading of the section.
void complain(Deck& deck, const std::string& section, const std::string& name, const std::string& what,
              Cause cause = Cause::between);

/// Adds an error with its cause.
void add_error(Deck& deck, Cause cause, const std::string& text);

/// Errors without those that may be consequences of others: if there is an error by_itself, missing keys and keys
/// without effect are left out.
std::vector<std::string> first_causes(const Deck& deck);

/// errors: core::InputError with the first causes, if there are any.
void throw_if_wrong(const Deck& deck);

/// One section, for the module that declares its keys: the functions above without deck and section.
struct Part {
  Deck& deck;
  std::string section;

  bool given(const std::string& name) const { return deck::given(deck, section, name); }
  /// True if the key has a value: given, chosen or by default.
  bool has(const std::string& name) const { return value(deck, section, name).origin != Origin::absent; }
  /// The record of a key.
  const Key& key(const std::string& name) const { return *find_key(deck.catalogue, section, name); }
  double number(const std::string& name) const { return deck::number(deck, section, name); }
  double number_in(const std::string& name, const PlainUnit& unit) const {
    return deck::number_in(deck, section, name, unit);
  }
  int integer(const std::string& name, int otherwise) const { return deck::integer(deck, section, name, otherwise); }
  std::string word(const std::string& name) const { return deck::word(deck, section, name); }
  std::vector<std::string> words(const std::string& name) const { return deck::words(deck, section, name); }
  /// The value that belongs to the given word. in: values in the order of the words of the key.
  template <class T>
  T choice(const std::string& name, std::initializer_list<T> values) const {
    return values.begin()[index_of_word(deck, section, name)];
  }
  void choose(const std::string& name, const auto& value, const std::string& why) const {
    deck::choose(deck, section, name, value, why);
  }
  /// choose() if the deck does not give the key.
  void fill(const std::string& name, const auto& value, const std::string& why) const {
    if (!given(name)) choose(name, value, why);
  }
  /// fill() with a value that follows from other keys.
  void follow(const std::string& name, const auto& value, const std::string& why) const {
    fill(name, value, why);
    mark_following(deck, section, name);
  }
  void complain(const std::string& name, const std::string& what, Cause cause = Cause::between) const {
    deck::complain(deck, section, name, what, cause);
  }

  /// Those of the names that the deck gives.
  std::vector<std::string> given_of(const std::vector<std::string>& names) const;
  /// Report each of the names that the deck does not give (demand) or gives (refuse).
  void demand(const std::vector<std::string>& names, const std::string& why) const;
  void refuse(const std::vector<std::string>& names, const std::string& why, Cause cause = Cause::between) const;
};

}  // namespace ehl::deck
