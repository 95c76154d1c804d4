#pragma once
// What a sweep varies, and the cases that follow.
#include <string>
#include <vector>

#include "deck/key.hpp"

namespace ehl::program {

/// One --vary: a key of the deck and the values it takes, as the deck would write them.
struct Variation {
  std::string section{};
  std::string name{};
  std::vector<std::string> values{};
};

/// Reads "section.key=LIST". LIST: values between commas, each a value of the key or, where the key is a number,
/// a:b:n (n values from a to b, evenly spaced) or a:b:n:log (evenly spaced logarithms; a, b > 0); values between a and
/// b are rounded to 12 digits. errors: core::InputError: another form, an unknown key (with the nearest), a value that
/// the key never takes (with what is allowed), a value twice.
Variation parse_variation(const std::string& text, const deck::Catalogue& catalogue);

/// All of them. in: the --vary and the --set of a command line.
/// errors: core::InputError with all complaints: those above, a key varied twice or varied and set, too many cases.
std::vector<Variation> parse_variations(const std::vector<std::string>& texts, const std::vector<std::string>& set,
                                        const deck::Catalogue& catalogue);

/// Cases of the product of all lists; 1 without any.
std::size_t number_of_cases(const std::vector<Variation>& variations);

/// The values of one case, one per variation; the first variation changes slowest. in: index < number_of_cases.
std::vector<std::string> values_of_case(const std::vector<Variation>& variations, std::size_t index);

/// The same as "section.key=value", what --set takes.
std::vector<std::string> overrides_of_case(const std::vector<Variation>& variations, std::size_t index);

}  // namespace ehl::program
