#pragma once
// Measured heights in a text file: rows, lists of x y z, and the ASCII formats of instruments.
#include <string>

#include "case/map_file.hpp"

namespace ehl::program {

/// Rows of constant y, or a list of x y z with the points of a regular grid in any order; ESRI's ASCII grid, ISO
/// 25178-71's SDF, Gwyddion's text. Cells stand between semicolons, tabs, commas or blanks; decimal commas; separators
/// at the end of every line; line ends of any system. in: the text without the mark of UTF-8; name of the file for
/// messages. dx_m: distance of points that the deck gives, in metres, NaN: none; of a list without units it is that
/// of x and y.
ReadHeights read_map_text(const std::string& text, const std::string& name, double dx_m);

}  // namespace ehl::program
