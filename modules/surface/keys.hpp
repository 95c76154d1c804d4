#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "surface/feature.hpp"

namespace ehl::surface {

/// Measured heights as the deck describes them, with lengths in a and heights in a^2/R.
struct MapInput {
  std::string file{};     ///< empty: complained about
  std::string dataset{};  ///< of a .h5
  double unit = 0.0;      ///< height of the number 1 in the file; NaN: not given, as the next two
  double dx = 0.0, dy = 0.0;
  double taper = 0.0;
  bool plane = true;           ///< levelling takes a plane away, else the mean alone
  double longest_wave = 0.0;   ///< cut-off wavelength above which waves are taken away; 0: none are
  double shortest_wave = 0.0;  ///< below which they are; 0: none are
};

/// What a surface carries: a feature, a map or, where the shape is empty, nothing.
struct Input {
  std::string shape{};               ///< as the deck calls it
  std::optional<Feature> feature{};  ///< not yet at its place
  std::optional<MapInput> map{};
  bool at_rest = false;
  double X = std::numeric_limits<double>::quiet_NaN();  ///< of the middle at T = 0; NaN: open
  double Y = 0.0;
};

/// Of lengths in the plane, and of heights.
struct Units {
  deck::PlainUnit a{.suffix = "_m"};       ///< Hertz radius
  deck::PlainUnit height{.suffix = "_m"};  ///< a^2/R
};

/// Keys of [surface1] and [surface2].
std::vector<deck::Key> keys();
Input read(deck::Deck& deck, const std::string& section, const Units& units);

}  // namespace ehl::surface
