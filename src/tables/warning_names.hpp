#pragma once
// The names of warnings in a table.
#include <string>

#include "core/warning.hpp"

namespace ehl::program {

/// The names of warnings, separated by blanks, each once, in the order of the warnings: "mesh domain"; "none" if there
/// is no warning.
std::string names_of_warnings(const core::Warnings& warnings);

/// The name of the warning about an estimated error of 100 % or more: the case converged, but
/// its numbers are not usable.
constexpr char hardly_an_error[] = "error-100";

/// The names with their meanings, as one line of the heading of a table.
std::string meaning_of_warnings();

}  // namespace ehl::program
