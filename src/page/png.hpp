#pragma once
// Small pictures as PNG within a page.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ehl::program {

using Rgb = std::array<std::uint8_t, 3>;

/// A picture whose points are indices into a table of colours.
struct IndexedPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Rgb> colours{};          ///< at most 256
  std::vector<std::uint8_t> points{};  ///< row by row from the top
};

/// The picture as a data URI. source: PNG specification, third edition (W3C). errors: std::runtime_error if zlib fails.
std::string png_uri(const IndexedPicture& picture);

}  // namespace ehl::program
