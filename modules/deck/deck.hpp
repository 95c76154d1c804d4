#pragma once
// A deck that was read against the catalogue of keys: one value per key, and every complaint about it.
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "deck/document.hpp"
#include "deck/key.hpp"

namespace ehl::deck {

/// Where the value of a key comes from. chosen: by the program, because the deck left it open.
enum class Origin { absent, by_default, given, chosen };

struct Value {
  Origin origin = Origin::absent;
  bool valid = true;     ///< false: given, but already complained about
  std::string text{};    ///< as written
  double number = 0.0;   ///< numbers and integers; NaN when absent or not valid
  std::string place{};   ///< where it was given
  std::string why{};     ///< how it was chosen
  bool follows = false;  ///< chosen, and made anew from the deck's other keys whenever it is read
  std::string from{};    ///< section whose keys stand for this one, which is as good as given; mostly none
  /// Somebody has asked for the number or the text. Only a test looks: a key that nobody reads must not be declared.
  mutable bool read = false;
};

/// What an error comes from, for first_causes(). by_itself: a section, key or word that does not exist, a value out of
/// its range, or a line that cannot be read. between: a rule between keys. idle: a key without influence.
enum class Cause { by_itself, between, missing, idle };

struct Deck {
  std::string name{};
  std::vector<std::string> folders{};  ///< where files that it names may lie, beside where the program runs
  Catalogue catalogue{};
  std::vector<Value> values{};        ///< one per key of the catalogue
  std::vector<Heading> headings{};    ///< the sections that the deck has
  std::vector<std::string> errors{};  ///< complaints so far, each a complete message
  std::vector<Cause> causes{};        ///< one per error
};

/// Reads a deck and checks every key by itself: known, once, readable, in range. Rules between keys belong to
/// check_influence() and to those who use them; they add to `errors` by complain(), and throw_if_wrong() ends it.
/// in: path of the deck, overrides "section.key=value", or "-section.key", which takes the key out. errors:
/// core::InputError when the file cannot be read at all.
Deck read(const std::string& path, const std::vector<std::string>& overrides, const Catalogue& catalogue);

/// The same of a text. path: what messages call it, beside which its files lie.
Deck read_text(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
               const Catalogue& catalogue);

/// The same for a document already parsed.
Deck validate(const Document& document, const std::vector<Assignment>& overrides, const Catalogue& catalogue);

/// The value of a key. errors: std::logic_error for a key that no module declared.
const Value& value(const Deck& deck, const std::string& section, const std::string& name);

/// True when the deck or the command line gives the key, whether valid or not, or it is computed from other keys.
bool given(const Deck& deck, const std::string& section, const std::string& name);

/// True when the section is one of every deck, or the deck gives a key that calls for the section's effect.
bool called_for(const Deck& deck, const std::string& section);

/// True when the key can act: its section is called for, and what the key needs beside it is there.
bool has_influence(const Deck& deck, const Key& key);

/// Number of a key: given, chosen or default; NaN when there is none or it was refused.
double number(const Deck& deck, const std::string& section, const std::string& name);

/// The unit of a quantity that a deck may give plainly, as `name`, or in SI, as name + suffix.
struct PlainUnit {
  std::string suffix{};
  double in_SI = std::numeric_limits<double>::quiet_NaN();
  bool known = false;  ///< the deck gives, right or wrong, what in_SI follows from
};

/// Such a quantity in its plain unit. Complains where both are given, or the one in SI and the unit is not known. A
/// default gives way to the one in SI. out: NaN where neither is there, or something is wrong.
double number_in(Deck& deck, const std::string& section, const std::string& name, const PlainUnit& unit);

/// number() for a whole number. limits: `otherwise` when there is none or it was refused.
int integer(const Deck& deck, const std::string& section, const std::string& name, int otherwise);

/// Word or text of a key; empty when there is none or it was refused.
std::string word(const Deck& deck, const std::string& section, const std::string& name);

/// Several words.
std::vector<std::string> words(const Deck& deck, const std::string& section, const std::string& name);

/// Which of the key's words is given; the first where there is none or it was refused.
std::size_t index_of_word(const Deck& deck, const std::string& section, const std::string& name);

/// Records a value that the program chose for an open key, for the effective deck and the report.
void choose(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& why);
void choose(Deck& deck, const std::string& section, const std::string& name, const std::string& text,
            const std::string& why);

/// Marks a value as one that follows from other keys, unless it is given: the effective deck tells it in a remark, so
/// that the keys it follows from may be changed there.
void mark_following(Deck& deck, const std::string& section, const std::string& name);

/// Records a number that follows from keys of the section `from`, which stand for this one: it counts as given. in: NaN
/// where something is wrong with them, and has been complained about.
void compute(Deck& deck, const std::string& section, const std::string& name, double number, const std::string& from,
             const std::string& why);
/// The same of a word, one of those that the key allows.
void compute(Deck& deck, const std::string& section, const std::string& name, const char* word, const std::string& from,
             const std::string& why);

/// Complains about every key that cannot act beside the others. To be called when compute() has said its words.
void check_influence(Deck& deck);

/// Adds the message "deck.ini:12: [grid] cells = 77: <what>". Of a number that was computed, what it follows from
/// stands first: the keys of that section on the command line, or else its heading.
/// The cause follows from the words: "is missing", "has no influence"; or it is said.
void complain(Deck& deck, const std::string& section, const std::string& name, const std::string& what);
void complain(Deck& deck, const std::string& section, const std::string& name, const std::string& what, Cause cause);

/// Adds an error with its cause.
void add_error(Deck& deck, Cause cause, const std::string& text);

/// The errors without those that may be the consequence of another one: what is missing beside an error by itself,
/// which may be about the key that is missing, and what is without influence beside either of these.
std::vector<std::string> first_causes(const Deck& deck);

/// errors: core::InputError with the first causes, when there are any.
void throw_if_wrong(const Deck& deck);

/// One section, as the module that declares its keys reads it: the functions above without deck and section.
struct Part {
  Deck& deck;
  std::string section;

  bool given(const std::string& name) const { return deck::given(deck, section, name); }
  double number(const std::string& name) const { return deck::number(deck, section, name); }
  double number_in(const std::string& name, const PlainUnit& unit) const {
    return deck::number_in(deck, section, name, unit);
  }
  int integer(const std::string& name, int otherwise) const { return deck::integer(deck, section, name, otherwise); }
  std::string word(const std::string& name) const { return deck::word(deck, section, name); }
  std::vector<std::string> words(const std::string& name) const { return deck::words(deck, section, name); }
  /// The value that stands for the word. in: values in the order of the words in the key's record.
  template <class T>
  T choice(const std::string& name, std::initializer_list<T> values) const {
    return values.begin()[index_of_word(deck, section, name)];
  }
  void choose(const std::string& name, const auto& value, const std::string& why) const {
    deck::choose(deck, section, name, value, why);
  }
  /// choose() where the deck leaves the key open.
  void fill(const std::string& name, const auto& value, const std::string& why) const {
    if (!given(name)) choose(name, value, why);
  }
  /// fill() with what follows from other keys.
  void follow(const std::string& name, const auto& value, const std::string& why) const {
    fill(name, value, why);
    mark_following(deck, section, name);
  }
  void complain(const std::string& name, const std::string& what) const { deck::complain(deck, section, name, what); }
  void complain(const std::string& name, const std::string& what, Cause cause) const {
    deck::complain(deck, section, name, what, cause);
  }

  /// Those of the names that the deck gives.
  std::vector<std::string> given_of(const std::vector<std::string>& names) const;
  /// Complains about each of the names that the deck does not give, or does.
  void demand(const std::vector<std::string>& names, const std::string& why) const;
  void refuse(const std::vector<std::string>& names, const std::string& why) const;
};

}  // namespace ehl::deck
