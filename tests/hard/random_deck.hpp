#pragma once
// Unexpected decks: random physical cases, and random damage to their text.
#include <cstdint>
#include <string>
#include <vector>

#include "support/random.hpp"

namespace hard {

using ehl::tests::Random;

/// A key of the program, as `ehl keys` lists it.
struct KnownKey {
  std::string section{};
  std::string name{};
};

/// Reads the list that `ehl keys` prints.
std::vector<KnownKey> read_known_keys(const std::string& listing);

struct Entry {
  std::string section{};
  std::string name{};
  std::string value{};
};

/// A file that a deck names.
struct File {
  std::string name{};
  std::string text{};
};

/// Shares of all decks.
struct Shares {
  double supplies = 0.25;  ///< share with a [supply]
  double heat = 0.15;      ///< share that become a typical contact with heat
  double lines = 0.1;      ///< share that become line contacts
  double inputs = 0.15;    ///< share that are a deck of inputs/ with other numbers
};

struct RandomDeck {
  std::string text{};
  std::vector<File> files{};
  std::vector<std::string> overrides{};  ///< "section.key=value", for --set
  int threads = 1;
  std::vector<std::string> damage{};  ///< the damage that was done; empty: the deck is intact
  bool ordinary = false;              ///< the program must accept the contact; a refusal is a fault
};

/// The deck of a seed, identical on every machine. in: keys: the keys of the program, which the damage may use; shares:
/// the shares of the kinds of deck. Physical cases: M log-uniform in 1 ... 1e4, L in 0 ... 30, in three languages;
/// grids up to 129 x 129 nodes, lines up to 1025.
RandomDeck random_deck(std::uint64_t seed, const std::vector<KnownKey>& keys, const Shares& shares);

/// A case that a user may want, common or rare. ordinary: stays true as long as nothing in it may be refused.
std::vector<Entry> random_case(Random& random, bool& ordinary);

/// Adds [transient] and, in some cases, [body], moving surfaces and probes. si: the contact is given in SI.
void add_in_time(std::vector<Entry>& entries, Random& random, bool si);

/// Adds one or both surfaces at rest to a steady contact.
void add_at_rest(std::vector<Entry>& entries, Random& random, bool si);

/// Makes some contacts elliptic, some of them at an angle. It has its own random numbers, so that the
/// other decks do not change.
void make_elliptic(std::vector<Entry>& entries, Random random, bool& ordinary);

/// Turns a share of decks into line contacts, most of them without keys about Y. It has its own random numbers.
void make_line(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// Gives some decks an oil by name, by a table or by the laws of a liquid, shear thinning, or friction. It
/// has its own random numbers.
void vary_oil(std::vector<Entry>& entries, std::vector<File>& files, Random random, bool& ordinary);

/// Gives a share of decks a [supply], some with passes, some with a variation in time. It has its own random numbers.
void vary_supply(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// Turns a share of decks into typical contacts with heat, and occasionally adds heat or flow thinning to others. It
/// has its own random numbers.
void add_heat(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// Replaces a share of decks by one of inputs/ with other numbers and a small mesh, and by the files that it names. It
/// has its own random numbers.
void take_input(std::vector<Entry>& entries, std::vector<File>& files, Random random, double share, bool& ordinary);

/// Adds stresses below the contact, with few planes to save time.
void add_subsurface(std::vector<Entry>& entries, Random& random);

/// A dry contact, in some cases with surfaces and with stresses below it.
std::vector<Entry> random_dry_case(Random& random);

/// The files that the entries name: measured maps, tables of a load.
std::vector<File> files_of(const std::vector<Entry>& entries, Random& random);

/// The deck as text. layout: comments, blanks, repeated headings, CRLF and a byte-order mark, none of
/// which changes the meaning.
std::string deck_text(const std::vector<Entry>& entries, Random& random);

/// Typing errors of a user: misspelt names, impossible values, keys missing, doubled, or in the wrong section.
void damage_entries(std::vector<Entry>& entries, const std::vector<KnownKey>& keys, Random& random,
                    std::vector<std::string>& done);

/// Accidents of a file: characters and lines lost, doubled or swapped; binary noise, very long lines, other encodings.
void damage_text(std::string& text, Random& random, std::vector<std::string>& done);

/// Replaces cells of a table by impossible, extreme or other values.
void damage_cells(std::string& text, Random& random, std::vector<std::string>& done);

/// Truncates a binary file, loses, clears or changes some of its bytes; half of the damage is in its first 4096 bytes.
void damage_bytes(std::string& bytes, Random& random, std::vector<std::string>& done);

/// A random whole number from low to high, both included.
int whole(Random& random, int low, int high);

/// Log-uniform between low and high.
double log_between(Random& random, double low, double high);

template <class Value>
Value pick(Random& random, const std::vector<Value>& values) {
  return values[static_cast<std::size_t>(whole(random, 0, static_cast<int>(values.size()) - 1))];
}

/// A number as a user may write it, with 3 to 9 digits.
std::string written(Random& random, double value);

}  // namespace hard
