#include "page/png.hpp"

#include <zlib.h>

#include <stdexcept>

namespace ehl::program {
namespace {

void append_word(std::string& text, std::uint32_t word) {
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>((word >> shift) & 0xFFU);
}

// A PNG chunk: length, name, content, and a checksum of name and content.
std::string chunk(const std::string& name, const std::string& content) {
  std::string made;
  append_word(made, static_cast<std::uint32_t>(content.size()));
  const std::string checked = name + content;
  made += checked;
  const auto* bytes = reinterpret_cast<const Bytef*>(checked.data());
  append_word(made, static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(checked.size()))));
  return made;
}

std::string compressed(const std::string& bytes) {
  uLongf length = compressBound(bytes.size());
  std::string made(length, '\0');
  if (compress2(reinterpret_cast<Bytef*>(made.data()), &length, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("a picture could not be compressed");
  made.resize(length);
  return made;
}

std::string base64(const std::string& bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8U | (k + i < bytes.size() ? static_cast<std::uint8_t>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += k + i <= bytes.size() ? letters[(three >> (18U - 6U * i)) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string png_uri(const IndexedPicture& picture) {
  std::string header;
  append_word(header, static_cast<std::uint32_t>(picture.width));
  append_word(header, static_cast<std::uint32_t>(picture.height));
  header += std::string("\x08\x03\x00\x00\x00", 5);  // eight bits per point, palette colours, no interlacing
  std::string colours, rows;
  for (const Rgb& colour : picture.colours)
    for (const std::uint8_t part : colour) colours += static_cast<char>(part);
  for (std::size_t j = 0; j < picture.height; ++j) {
    rows += '\0';  // filter 0: the row is stored unfiltered
    rows.append(picture.points.begin() + static_cast<std::ptrdiff_t>(j * picture.width),
                picture.points.begin() + static_cast<std::ptrdiff_t>((j + 1) * picture.width));
  }
  return "data:image/png;base64," + base64("\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("PLTE", colours) +
                                           chunk("IDAT", compressed(rows)) + chunk("IEND", ""));
}

}  // namespace ehl::program
