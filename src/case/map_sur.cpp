#include "case/map_sur.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "case/map_cells.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

constexpr std::size_t sur_header_bytes = 512;

// Positions of the fields in the header.
enum SurField : std::size_t {
  byte_order = 12,
  number_of_objects = 14,
  kind_of_object = 18,
  special_points = 86,
  bits_per_height = 98,
  least_height = 100,
  points_of_line = 108,
  number_of_lines = 112,
  x_spacing = 120,
  y_spacing = 124,
  z_spacing = 128,
  x_unit = 180,
  y_unit = 196,
  z_unit = 212,
  inverted = 290,
  bytes_of_comment = 334,
  bytes_of_private_zone = 336,
};
constexpr std::size_t bytes_of_unit = 16;

class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}
  int integer16(std::size_t at) const { return static_cast<std::int16_t>(little_endian(at, 2)); }
  std::int64_t integer32(std::size_t at) const { return static_cast<std::int32_t>(little_endian(at, 4)); }
  double real32(std::size_t at) const { return static_cast<double>(std::bit_cast<float>(little_endian(at, 4))); }
  std::string text(std::size_t at, std::size_t length) const {
    return deck::trimmed(bytes_.substr(at, length).substr(0, bytes_.substr(at, length).find('\0')));
  }

 private:
  std::uint32_t little_endian(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t k = count; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[at + k]);
    return value;
  }
  const std::string& bytes_;
};

// What this reader does not take; empty: it takes the file.
std::string why_not(const Bytes& header) {
  constexpr int profile = 1, surface = 2;  // Gwyddion calls its surfaces profiles
  if (const int order = header.integer16(byte_order); order != 0 && order != 1)
    return "its numbers are in the byte order of old Macintoshs";
  if (const int objects = header.integer16(number_of_objects); objects > 1)
    return fmt::format("it holds {} objects", objects);
  if (const int kind = header.integer16(kind_of_object); kind != profile && kind != surface)
    return fmt::format("it holds no surface, but an object of kind {}", kind);
  if (const int bits = header.integer16(bits_per_height); bits != 16 && bits != 32)
    return fmt::format("its heights have {} bits", bits);
  if (header.integer16(inverted) != 0) return "its heights are marked as inverted";
  return {};
}

// A spacing in metres; NaN if the unit is not stated. wrong: what else the header has.
double spacing(const Bytes& header, const char* axis, SurField number, SurField unit, std::string& wrong) {
  const double step = header.real32(number);
  const std::string text = header.text(unit, bytes_of_unit);
  const double metres = metres_of(text);
  if (!(step > 0.0) || !std::isfinite(step))
    wrong = fmt::format("its header states no positive step of {}", axis);
  else if (!text.empty() && std::isnan(metres))
    wrong = fmt::format("the unit {} of its {} is no length", deck::quoted(text), axis);
  return step * metres;
}

}  // namespace

ReadHeights read_map_sur(const std::string& bytes, const std::string& name) {
  const std::string remedy = ": open it with Gwyddion and save it as ASCII data matrix (.txt, with the heading)";
  if (bytes.starts_with("DSCOMPRESSED")) return name + ": is compressed" + remedy;
  if (!bytes.starts_with("DIGITAL SURF") || bytes.size() < sur_header_bytes)
    return name + ": is no .sur of Digital Surf: it does not begin with the header of 512 bytes";
  const Bytes header(bytes);
  if (const std::string why = why_not(header); !why.empty()) return name + ": " + why + remedy;
  const std::int64_t nx = header.integer32(points_of_line), ny = header.integer32(number_of_lines);
  if (nx < 1 || ny < 1 || static_cast<double>(nx) * static_cast<double>(ny) > static_cast<double>(most_heights))
    return fmt::format("{}: its header states {} x {} points", name, nx, ny);
  const auto width = static_cast<std::size_t>(header.integer16(bits_per_height)) / 8;
  const auto points = static_cast<std::size_t>(nx * ny);
  const std::size_t begin =
      sur_header_bytes + static_cast<std::size_t>(static_cast<std::uint16_t>(header.integer16(bytes_of_comment))) +
      static_cast<std::size_t>(static_cast<std::uint16_t>(header.integer16(bytes_of_private_zone)));
  if (bytes.size() != begin + points * width)
    return fmt::format("{}: has {} bytes, and its header states {}{}", name, bytes.size(), begin + points * width,
                       remedy);
  std::string wrong;
  MapInFile map{.dx_m = spacing(header, "x", x_spacing, x_unit, wrong),
                .dy_m = spacing(header, "y", y_spacing, y_unit, wrong)};
  spacing(header, "z", z_spacing, z_unit, wrong);
  if (!wrong.empty()) return name + ": " + wrong;
  map.unit_m = metres_of(header.text(z_unit, bytes_of_unit));
  map.heights = {static_cast<int>(nx), static_cast<int>(ny), std::vector<double>(points)};
  const bool some_missing = header.integer16(special_points) != 0;
  const std::int64_t missing = header.integer32(least_height) - 2;
  const double step = header.real32(z_spacing);
  for (std::size_t n = 0; n < points; ++n) {
    const std::size_t at = begin + n * width;
    const std::int64_t z = width == 2 ? header.integer16(at) : header.integer32(at);
    map.heights.values[n] = some_missing && z == missing ? core::unknown : step * static_cast<double>(z);
  }
  return map;
}

}  // namespace ehl::program
