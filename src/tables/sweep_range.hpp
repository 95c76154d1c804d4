#pragma once
// What a sweep varies, and the cases that follow.
#include <string>
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

/// One --vary: a key of the deck and the values it takes, as the deck would write them; or several keys that change
/// together.
struct Variation {
  struct Key {
    std::string section{};
    std::string name{};
  };
  std::vector<Key> keys{};
  std::vector<std::vector<std::string>> values{};  ///< of its cases, a value for each key
  std::string file{};                              ///< of --cases: what the head of a table says of it; else empty
};
std::string name_of(const Variation::Key& key);

/// Reads "section.key=LIST". LIST: values between commas, each a value of the key or, where the key is a number,
/// a:b:n (n values from a to b, evenly spaced) or a:b:n:log (evenly spaced logarithms; a, b > 0); values between a and
/// b are rounded to 12 digits. "section.key,section.key=LIST": keys that change together; LIST: values between colons,
/// one for each key, of each case between commas. errors: core::InputError: another form, an unknown key (with the
/// nearest), a value that the key never takes (with what is allowed), a value twice.
Variation parse_variation(const std::string& text, const deck::Catalogue& catalogue);

/// The cases of a table, FILE.csv: a line of keys, "contact.load" or "contact.load [kN]", and for each case a line of
/// values, as spreadsheets, R and Python write them (deck/text_table.hpp). errors: core::FileError; core::InputError:
/// an unknown key, a line with more or fewer cells, a value that the key never takes, a case twice.
Variation read_cases(const std::string& path, const deck::Catalogue& catalogue);

/// All of them. in: the --vary, the --set and the --cases of a command line; the file's cases vary slowest.
/// errors: core::InputError with all complaints: those above, a key varied twice or varied and set, too many cases.
std::vector<Variation> parse_variations(const std::vector<std::string>& texts, const std::vector<std::string>& set,
                                        const deck::Catalogue& catalogue, const std::string& cases = "");

/// Cases of the product of all lists; 1 without any.
std::size_t number_of_cases(const std::vector<Variation>& variations);

/// All keys that vary, "section.key".
std::vector<std::string> varied_keys(const std::vector<Variation>& variations);

/// The values of one case, one per key; the first variation changes slowest. in: index < number_of_cases.
std::vector<std::string> values_of_case(const std::vector<Variation>& variations, std::size_t index);

/// The same as "section.key=value", what --set takes.
std::vector<std::string> overrides_of_case(const std::vector<Variation>& variations, std::size_t index);

}  // namespace ehl::program
