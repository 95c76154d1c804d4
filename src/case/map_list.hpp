#pragma once
// Reads lists of x y z, the points of a regular grid in any order.
#include <string>
#include <vector>

#include "case/map_cells.hpp"
#include "case/map_file.hpp"

namespace ehl::program {

/// True if every line has three cells.
bool is_list(const std::vector<TextLine>& lines);

/// The heights on the grid of the coordinates; points that are not listed are missing. in: lines of numbers; the
/// heading, which may name the columns with their units, "x [um]"; name of the file; dx_m as for read_map_text().
ReadHeights read_list(const std::vector<TextLine>& lines, const std::vector<std::string>& heading,
                      const std::string& name, double dx_m);

/// The unit of the distances in a file, in metres: m, mm, um or nm, whichever makes the spacing of the file equal to
/// that of the deck within one per cent; `otherwise` if the deck gives none or no unit fits.
double unit_of_coordinates(double spacing, double dx_m, double otherwise);

}  // namespace ehl::program
