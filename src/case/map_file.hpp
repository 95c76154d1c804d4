#pragma once
// A file of measured heights: rows of constant y, the first at the smallest y.
#include <string>
#include <variant>

#include "surface/height_map.hpp"

namespace ehl::program {

/// The heights, or what is wrong with them: "map.csv:12: ...", "map.h5: height: row 3, ...".
using ReadHeights = std::variant<surface::Heights, std::string>;

/// in: path of a .csv or .h5; dataset of a .h5. errors: core::FileError where the file cannot be read at all.
ReadHeights read_heights(const std::string& path, const std::string& dataset);

}  // namespace ehl::program
