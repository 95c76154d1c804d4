#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "deck/deck.hpp"
#include "surface/feature.hpp"

namespace ehl::surface {

/// Measured heights as described in the deck; lengths in a, heights in a^2/R.
struct MapInput {
  std::string file{};     ///< empty: an error has been reported
  std::string dataset{};  ///< in an .h5 file
  double unit = 0.0;      ///< height of the number 1 in the file; NaN: not given, also dx and dy
  double dx = 0.0, dy = 0.0;
  double taper = 0.0;
  bool plane = true;           ///< levelling subtracts a plane; false: only the mean
  double longest_wave = 0.0;   ///< cut-off wavelength above which waves are removed; 0: none
  double shortest_wave = 0.0;  ///< cut-off wavelength below which waves are removed; 0: none
};

/// Relief of a surface: a feature, a map, or nothing if `shape` is empty.
struct Input {
  std::string shape{};               ///< as in the deck
  std::optional<Feature> feature{};  ///< without its position
  std::optional<MapInput> map{};
  bool at_rest = false;
  double X = core::unknown;  ///< of the centre at T = 0; NaN: not given
  double Y = 0.0;
};

/// Units of lengths in the plane, and of heights.
struct Units {
  deck::PlainUnit a{.suffix = "_m"};       ///< Hertz radius
  deck::PlainUnit height{.suffix = "_m"};  ///< a^2/R
};

/// Keys of [surface1] and [surface2].
std::vector<deck::Key> keys();
/// Reads the relief of one surface. in: section, "surface1" or "surface2". Errors are added to the deck.
Input read(deck::Deck& deck, const std::string& section, const Units& units);

}  // namespace ehl::surface
