#include "case/map_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/map_cells.hpp"
#include "case/map_list.hpp"
#include "deck/text.hpp"

namespace ehl::program {
namespace {

// The heading of a file and the lines after it.
struct MapText {
  std::vector<std::string> heading{};  ///< including comments, without their #
  std::vector<TextLine> lines{};       ///< the lines of numbers
  int blank = 0;                       ///< number of the first blank line between lines of numbers
};

// Separates the heading from the numbers. in: the heading is one line of words, or lines of "name: value".
MapText divided(const std::string& text) {
  MapText divided;
  int number = 0, blank = 0;
  bool words = false;
  for (const std::string& raw : lines_of(text)) {
    ++number;
    const std::size_t hash = raw.find('#');
    if (hash != std::string::npos) divided.heading.push_back(deck::trimmed(raw.substr(hash + 1)));
    // A tab at the end of a line is kept: it separates an empty cell.
    const std::string line = raw.substr(0, hash);
    if (deck::trimmed(line).empty()) {
      if (hash == std::string::npos && blank == 0 && !divided.lines.empty()) blank = number;
      continue;
    }
    if (divided.lines.empty() && !is_numbers(line)) {
      const bool entry = line.find_first_of(":=") != std::string::npos;
      if (entry || !words) {
        words |= !entry;
        divided.heading.push_back(deck::trimmed(line));
        continue;
      }
    }
    if (blank > 0 && divided.blank == 0) divided.blank = blank;
    divided.lines.push_back({number, line});
  }
  return divided;
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::ranges::any_of(names, [&](const char* one) { return name == one; });
}

// Reads the headings of Gwyddion and other programs. in: map: its number of points along x and y must be set.
void read_heading(const std::vector<std::string>& heading, MapInFile& map) {
  for (const std::string& line : heading) {
    const auto [name, value] = entry_of(line, false);
    if (name == "width") map.dx_m = length_of(value) / map.heights.nx;
    if (name == "height") map.dy_m = length_of(value) / map.heights.ny;
    if (is_one_of(name, {"value units", "z unit", "z units", "unit", "units"})) map.unit_m = metres_of(value);
    if (is_one_of(name, {"dx", "x spacing", "pixel size", "lateral spacing"})) map.dx_m = length_of(value);
    if (is_one_of(name, {"dy", "y spacing"})) map.dy_m = length_of(value);
  }
  if (std::isnan(map.dy_m)) map.dy_m = map.dx_m;
}

ReadHeights read_rows(const MapText& text, const std::string& name) {
  if (text.blank > 0)
    return fmt::format("{}:{}: a line without heights between others: the map has a gap", name, text.blank);
  MapInFile map;
  surface::Heights& heights = map.heights;
  const std::string wrong = read_numbers(text.lines, name, [&](const std::vector<double>& row) -> std::string {
    if (heights.ny > 0 && static_cast<int>(row.size()) != heights.nx)
      return fmt::format("{} heights in this line, but {} in those before", row.size(), heights.nx);
    heights.values.insert(heights.values.end(), row.begin(), row.end());
    heights.nx = static_cast<int>(row.size());
    ++heights.ny;
    return heights.values.size() > most_heights ? "more than 10^8 heights" : "";
  });
  if (!wrong.empty()) return wrong;
  read_heading(text.heading, map);
  return map;
}

// Reads the cells of all lines, however many a line has. in: the number of cells expected.
std::string read_cells(const std::vector<TextLine>& lines, const std::string& name, std::size_t wanted,
                       std::vector<double>& values) {
  std::string wrong = read_numbers(lines, name, [&](const std::vector<double>& row) {
    values.insert(values.end(), row.begin(), row.end());
    return std::string();
  });
  if (!wrong.empty() || values.size() == wanted) return wrong;
  return fmt::format("{}: {} heights, but its heading states {}", name, values.size(), wanted);
}

struct Entries {
  std::vector<std::pair<std::string, std::string>> all{};
  double number(const char* name) const {
    for (const auto& [key, value] : all)
      if (key == name) return deck::read_number(value).value;
    return std::nan("");
  }
};

bool is_count(double n) { return n >= 1.0 && n <= 1e8 && n == std::floor(n); }

// ISO 25178-71: a heading of "name = value", the heights, and a trailer, each ended by a line with a star.
ReadHeights read_sdf(const std::vector<std::string>& lines, const std::string& name) {
  Entries heading;
  std::size_t n = 1;
  for (; n < lines.size() && deck::trimmed(lines[n]) != "*"; ++n) heading.all.push_back(entry_of(lines[n], false));
  std::vector<TextLine> rows;
  for (++n; n < lines.size() && deck::trimmed(lines[n]) != "*"; ++n)
    if (!deck::trimmed(lines[n]).empty()) rows.push_back({static_cast<int>(n) + 1, lines[n]});
  const double nx = heading.number("numpoints"), ny = heading.number("numprofiles");
  MapInFile map{.unit_m = heading.number("zscale"), .dx_m = heading.number("xscale"), .dy_m = heading.number("yscale")};
  if (!is_count(nx) || !is_count(ny) || !(map.unit_m > 0.0) || !(map.dx_m > 0.0) || !(map.dy_m > 0.0))
    return name + ": its heading lacks NumPoints, NumProfiles, Xscale, Yscale or Zscale (ISO 25178-71)";
  map.heights.nx = static_cast<int>(nx);
  map.heights.ny = static_cast<int>(ny);
  const std::string wrong = read_cells(rows, name, static_cast<std::size_t>(nx * ny), map.heights.values);
  if (!wrong.empty()) return wrong;
  return map;
}

// ESRI's ASCII grid: lines of "name value", then rows that begin with the largest y.
ReadHeights read_esri(const std::vector<std::string>& lines, const std::string& name, double dx_m) {
  Entries heading;
  std::vector<TextLine> rows;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const std::string line = deck::trimmed(lines[n]);
    const auto entry = entry_of(line, true);
    if (rows.empty() && is_one_of(entry.first, {"ncols", "nrows", "cellsize", "dx", "dy", "nodata_value", "xllcorner",
                                                "yllcorner", "xllcenter", "yllcenter"}))
      heading.all.push_back(entry);
    else if (!line.empty())
      rows.push_back({static_cast<int>(n) + 1, lines[n]});
  }
  const double nx = heading.number("ncols"), ny = heading.number("nrows"), cell = heading.number("cellsize");
  if (!is_count(nx) || !is_count(ny) || !(cell > 0.0)) return name + ": its heading lacks ncols, nrows or cellsize";
  std::vector<double> values;
  if (std::string wrong = read_cells(rows, name, static_cast<std::size_t>(nx * ny), values); !wrong.empty())
    return wrong;
  MapInFile map;
  map.heights = {static_cast<int>(nx), static_cast<int>(ny), values};
  const double none = heading.number("nodata_value");
  for (int l = 0; l < map.heights.ny; ++l)
    for (int k = 0; k < map.heights.nx; ++k) {
      const double z = values[static_cast<std::size_t>((map.heights.ny - 1 - l) * map.heights.nx + k)];
      map.heights(k, l) = z == none ? std::nan("") : z;
    }
  map.dx_m = map.dy_m = cell * unit_of_coordinates(cell, dx_m, 1.0);
  return map;
}

}  // namespace

ReadHeights read_map_text(const std::string& text, const std::string& name, double dx_m) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return name + ": is text in UTF-16: save it in UTF-8";
  if (text.starts_with("aISO-1.0") || text.starts_with("aBCR-1.0")) return read_sdf(lines_of(text), name);
  if (text.starts_with("bISO-1.0") || text.starts_with("bBCR-1.0"))
    return name + ": is a binary file of ISO 25178-71: save it as its ASCII form with Gwyddion";
  if (text.find('\0') != std::string::npos)
    return name + ": is not a text file: open it with Gwyddion and save it as ASCII data matrix (.txt)";
  if (entry_of(text.substr(0, text.find_first_of("\r\n")), true).first == "ncols")
    return read_esri(lines_of(text), name, dx_m);
  const MapText parts = divided(text);
  if (!parts.lines.empty() && is_list(parts.lines)) return read_list(parts.lines, parts.heading, name, dx_m);
  return read_rows(parts, name);
}

}  // namespace ehl::program
