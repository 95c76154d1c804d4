#pragma once
// The values of a range, and the elements of a list.
#include <string>
#include <vector>

namespace ehl::program {

constexpr double most_cases_of_sweep = 1000000.0;

/// The text between separators, without blanks at the ends.
std::vector<std::string> parts_between(const std::string& text, char separator);

/// The values of "a:b:n" (evenly spaced) or of "a:b:n:log" (evenly spaced logarithms). in: said: the beginning of an
/// error message. errors: core::InputError.
std::vector<std::string> values_of_range(const std::string& text, const std::string& said);

}  // namespace ehl::program
