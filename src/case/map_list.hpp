#pragma once
// Lists of x y z, the points of a regular grid in any order.
#include <string>
#include <vector>

#include "case/map_cells.hpp"
#include "case/map_file.hpp"

namespace ehl::program {

/// True where every line has three cells.
bool is_list(const std::vector<TextLine>& lines);

/// The heights on the grid of the coordinates; points that are not listed are missing. in: lines of the heading, which
/// may name the columns with their units, "x [um]"; dx_m as read_map_text() has it.
ReadHeights read_list(const std::vector<TextLine>& lines, const std::vector<std::string>& heading,
                      const std::string& name, double dx_m);

/// Metres of the unit in which a file counts distances: that among m, mm, um and nm by which its distance of points is
/// the deck's, to a hundredth; `otherwise` where the deck gives none, or none of them fits.
double unit_of_coordinates(double spacing, double dx_m, double otherwise);

}  // namespace ehl::program
