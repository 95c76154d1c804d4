#pragma once
// Reads a file of measured heights. Rows have constant y; the first has the smallest y.
#include <string>
#include <variant>

#include "core/constants.hpp"
#include "surface/height_map.hpp"

namespace ehl::program {

/// The heights of a file, and the units and distances that its heading states.
struct MapInFile {
  surface::Heights heights{};     ///< missing points have been filled
  int filled = 0;                 ///< number of missing points that were filled
  double unit_m = core::unknown;  ///< height of the number 1, in metres; NaN: not stated
  double dx_m = core::unknown;    ///< distance between points along x; NaN: not stated
  double dy_m = core::unknown;    ///< distance between points along y; NaN: not stated
};

/// The heights, or an error message: "map.csv:12: ...", "map.h5: height: row 3, ...".
using ReadHeights = std::variant<MapInFile, std::string>;

/// in: path of a text file (.csv, .txt, .dat, .asc, .xyz, .sdf), of a .sur or of an HDF5 file (.h5); dataset in the
/// latter; distance between points that the deck gives [m], NaN: none. errors: core::FileError if the file cannot be
/// read.
ReadHeights read_heights(const std::string& path, const std::string& dataset, double dx_m);

/// "30 x 7 points are too few: at least 8 x 8"; empty if there are enough.
std::string too_few_points(int nx, int ny);

}  // namespace ehl::program
