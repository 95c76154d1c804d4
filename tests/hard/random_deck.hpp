#pragma once
// Decks that nobody would think of: random physical cases, and random damage to their text.
#include <cstdint>
#include <string>
#include <vector>

#include "support/random.hpp"

namespace hard {

using ehl::tests::Random;

/// A key of the program as `ehl keys` lists it.
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

/// What lies beside a deck that names it.
struct File {
  std::string name{};
  std::string text{};
};

/// Of all decks.
struct Shares {
  double supplies = 0.25;  ///< with a [supply]
  double heat = 0.15;      ///< that become a usual contact with heat
  double lines = 0.1;      ///< that become line contacts
};

struct RandomDeck {
  std::string text{};
  std::vector<File> files{};
  std::vector<std::string> overrides{};  ///< "section.key=value", for --set
  int threads = 1;
  std::vector<std::string> damage{};  ///< what was done to it on purpose; empty: a deck in good faith
  bool ordinary = false;              ///< a contact that must be taken: to refuse it is a fault of the program
};

/// The same deck for the same seed and keys, on every machine. in: the keys that the program has, targets of the
/// damage; the shares of the decks. Physical cases: M log-uniform 1 ... 1e4, L 0 ... 30, in three languages, grids up
/// to 129 x 129 nodes, lines up to 1025.
RandomDeck random_deck(std::uint64_t seed, const std::vector<KnownKey>& keys, const Shares& shares);

/// A case in good faith: what a user may want, common or rare. ordinary: left true while nothing in it can be refused.
std::vector<Entry> random_case(Random& random, bool& ordinary);

/// [transient], and with it [body], surfaces that move and probes, each in some cases. si: the contact is given in SI.
void add_in_time(std::vector<Entry>& entries, Random& random, bool si);

/// A surface that stands still in a steady contact, or both.
void add_at_rest(std::vector<Entry>& entries, Random& random, bool si);

/// Now and then an ellipse, some of them aslant; drawn for itself, so that the other decks stay what they are.
void make_elliptic(std::vector<Entry>& entries, Random random, bool& ordinary);

/// A share of decks becomes a line contact, most of them without what they had across the motion; likewise.
void make_line(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// Now and then an oil by name, by a table or by the laws of a liquid, one that thins, and friction; drawn for itself.
void vary_oil(std::vector<Entry>& entries, std::vector<File>& files, Random random, bool& ordinary);

/// In a share of decks a [supply], some with passes, and what varies of it in time; likewise.
void vary_supply(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// A share of decks becomes a usual contact with heat, others have it now and then, or the pressure's flow that thins;
/// drawn for itself.
void add_heat(std::vector<Entry>& entries, Random random, double share, bool& ordinary);

/// Stresses below the contact; few planes, for the time.
void add_subsurface(std::vector<Entry>& entries, Random& random);

/// A contact without lubricant, some with surfaces and with stresses below it.
std::vector<Entry> random_dry_case(Random& random);

/// The files that the entries name: measured maps, tables of a load.
std::vector<File> files_of(const std::vector<Entry>& entries, Random& random);

/// As a text; layout: with comments, blanks, repeated headings, CRLF, a byte order mark, which all change nothing.
std::string deck_text(const std::vector<Entry>& entries, Random& random);

/// Slips of a user: misspelt names, impossible values, keys lost, doubled, in the wrong section.
void damage_entries(std::vector<Entry>& entries, const std::vector<KnownKey>& keys, Random& random,
                    std::vector<std::string>& done);

/// Accidents of a file: characters and lines lost, doubled, swapped; binary noise, very long lines, other encodings.
void damage_text(std::string& text, Random& random, std::vector<std::string>& done);

/// A whole number between low and high, both included.
int whole(Random& random, int low, int high);

/// Log-uniform between low and high.
double log_between(Random& random, double low, double high);

template <class Value>
Value pick(Random& random, const std::vector<Value>& values) {
  return values[static_cast<std::size_t>(whole(random, 0, static_cast<int>(values.size()) - 1))];
}

/// A number as a user might write it, with 3 to 9 digits.
std::string written(Random& random, double value);

}  // namespace hard
