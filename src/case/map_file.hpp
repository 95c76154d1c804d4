#pragma once
// A file of measured heights: rows of constant y, the first at the smallest y.
#include <limits>
#include <string>
#include <variant>

#include "surface/height_map.hpp"

namespace ehl::program {

/// Heights of a file, and what its heading states of units and distances.
struct MapInFile {
  surface::Heights heights{};                                ///< missing points are filled
  int filled = 0;                                            ///< number of missing points
  double unit_m = std::numeric_limits<double>::quiet_NaN();  ///< height of the number 1 in metres; NaN: not stated
  double dx_m = std::numeric_limits<double>::quiet_NaN();    ///< distance of points along x; NaN: not stated
  double dy_m = std::numeric_limits<double>::quiet_NaN();    ///< along y
};

/// The heights, or what is wrong with them: "map.csv:12: ...", "map.h5: height: row 3, ...".
using ReadHeights = std::variant<MapInFile, std::string>;

/// in: path of a text file (.csv, .txt, .dat, .asc, .xyz, .sdf) or of a .h5; dataset of a .h5; distance of points that
/// the deck gives [m], NaN: none. errors: core::FileError where the file cannot be read at all.
ReadHeights read_heights(const std::string& path, const std::string& dataset, double dx_m);

/// "30 x 7 points are too few: at least 8 x 8"; empty where they are enough.
std::string too_few_points(int nx, int ny);

/// Fills missing points, NaN, so that each is the mean of its neighbours: a plane stays one. Counts them.
/// out: what is wrong: too many are missing to be filled from the others; empty where nothing is.
std::string fill_missing(MapInFile& map);

}  // namespace ehl::program
