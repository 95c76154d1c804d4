#pragma once
// What the pictures of `ehl plot` are: their format, size and names.
#include <string>
#include <vector>

#include "commands/arguments.hpp"
#include "commands/figures.hpp"

namespace ehl::program {

struct Pictures {
  std::string format{};              ///< png, svg or pdf
  std::vector<Setting> settings{};   ///< of the size, for the scripts
  std::vector<std::string> names{};  ///< one for each figure
};

/// From --format, --width and --output. in: the figures that are drawn. errors: core::InputError: no such format or
/// size, a movie in another format than GIF, a name that ends otherwise than the format, a
/// folder that is none.
Pictures pictures_of(const Arguments& arguments, const std::vector<Figure>& figures);

}  // namespace ehl::program
