#pragma once
// Warnings as words of a table.
#include <string>
#include <vector>

namespace ehl::program {

/// The names of warnings, each once and in their order, with blanks between them: "mesh domain"; "none" where there is
/// no warning, "other" for one that has no name. A name says what a warning is about and never changes; the sentences
/// may. in: the sentences.
std::string names_of_warnings(const std::vector<std::string>& sentences);

/// The name of an estimated error of 100 % and more: the case converged, and says little.
constexpr char hardly_an_error[] = "error-100";

/// The names and what they say, as a line of the head of a table.
std::string meaning_of_warnings();

}  // namespace ehl::program
