#pragma once
// Reads measured heights from text files: rows, lists of x y z, and the ASCII formats of instruments.
#include <string>

#include "case/map_file.hpp"

namespace ehl::program {

/// Reads rows of constant y; lists of x y z with the points of a regular grid in any order; ESRI's ASCII grid; SDF of
/// ISO 25178-71; the text of Gwyddion. Cells are separated by semicolons, tabs, commas or blanks. Decimal commas,
/// separators at the end of lines, and the line ends of all systems are accepted.
/// in: the text without a byte-order mark; name of the file for messages; dx_m: distance between points that the deck
/// gives, in metres, NaN: none. In a list without units it determines the unit of x and y.
ReadHeights read_map_text(const std::string& text, const std::string& name, double dx_m);

}  // namespace ehl::program
