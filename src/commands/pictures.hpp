#pragma once
// The format, size and names of the pictures of `ehl plot`.
#include <string>
#include <vector>

#include "commands/arguments.hpp"
#include "commands/figures.hpp"

namespace ehl::program {

struct Pictures {
  std::string format{};              ///< png, svg or pdf
  std::vector<Setting> settings{};   ///< the size, for the scripts
  std::vector<std::string> names{};  ///< names of the files, one per figure
};

/// The pictures for --format, --width and --output. in: the figures that are drawn. errors: core::InputError for an
/// unknown format or size, a movie in a format other than GIF, a name whose ending contradicts the format, or a
/// folder that is no folder.
Pictures pictures_of(const Arguments& arguments, const std::vector<Figure>& figures);

}  // namespace ehl::program
