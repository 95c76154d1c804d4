#pragma once
// What a sweep varies, and the cases that result.
#include <string>
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

/// One --vary: a key of the deck and its values, written as in the deck; or several keys that vary together.
struct Variation {
  struct Key {
    std::string section{};
    std::string name{};
  };
  std::vector<Key> keys{};
  std::vector<std::vector<std::string>> values{};  ///< for each case, one value per key
  std::string file{};                              ///< --cases: line of the heading about this file
};
/// The key as "section.key".
std::string name_of(const Variation::Key& key);

/// Reads "section.key=LIST". LIST: values separated by commas. If the key is a number, an element may also be a:b:n (n
/// values from a to b, evenly spaced) or a:b:n:log (evenly spaced logarithms; a, b > 0); the values between a and b
/// are rounded to 12 digits.
/// "section.key,section.key=LIST": keys varied together. LIST: the cases separated by commas; in each case one value
/// per key, separated by colons.
/// errors: core::InputError for another form, an unknown key (with the nearest), a value that the key cannot take (with
/// what is allowed), or a value given twice.
Variation parse_variation(const std::string& text, const deck::Catalogue& catalogue);

/// Reads a table of cases from a CSV file: one line of keys, "contact.load" or "contact.load [kN]", and one line of
/// values per case, as spreadsheets, R and Python write them (deck/text_table.hpp).
/// errors: core::FileError; core::InputError for an unknown key, a line with more or fewer cells, a value that the key
/// cannot take, or a case given twice.
Variation read_cases(const std::string& path, const deck::Catalogue& catalogue);

/// All variations of a command line. in: the --vary, the --set and the --cases; the cases of the file vary slowest.
/// errors: core::InputError with all messages: those above, a key that is varied twice or both
/// varied and set, too many cases.
std::vector<Variation> parse_variations(const std::vector<std::string>& texts, const std::vector<std::string>& set,
                                        const deck::Catalogue& catalogue, const std::string& cases = "");

/// The number of cases in the product of all variations; 1 if there are none.
std::size_t number_of_cases(const std::vector<Variation>& variations);

/// All varied keys, "section.key".
std::vector<std::string> varied_keys(const std::vector<Variation>& variations);

/// The values of one case, one per key; the first variation changes slowest. in: index < number_of_cases.
std::vector<std::string> values_of_case(const std::vector<Variation>& variations, std::size_t index);

/// The values of one case as "section.key=value", the form that --set takes.
std::vector<std::string> overrides_of_case(const std::vector<Variation>& variations, std::size_t index);

}  // namespace ehl::program
