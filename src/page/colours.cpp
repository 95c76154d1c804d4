#include "page/colours.hpp"

#include <algorithm>
#include <cmath>

namespace ehl::program {
namespace {

constexpr std::size_t shades = 120;  // the table holds as many darker shades again, for the lines of equal value
constexpr std::size_t no_number = 2 * shades;

struct Stop {
  double at;
  Rgb colour;
};

const std::vector<Stop>& stops_of(Colours colours) {
  static const std::vector<Stop> pressure{
      {0.0, {255, 255, 255}}, {0.25, {253, 212, 158}}, {0.5, {252, 141, 89}}, {0.8, {179, 0, 0}}, {1.0, {77, 0, 0}}};
  static const std::vector<Stop> film{{0.0, {8, 29, 88}},
                                      {0.25, {34, 94, 168}},
                                      {0.5, {65, 182, 196}},
                                      {0.75, {199, 233, 180}},
                                      {1.0, {255, 255, 229}}};
  static const std::vector<Stop> temperature{
      {0.0, {255, 255, 255}}, {0.3, {254, 217, 118}}, {0.6, {241, 105, 19}}, {0.85, {166, 3, 101}}, {1.0, {63, 0, 77}}};
  return colours == Colours::film ? film : colours == Colours::pressure ? pressure : temperature;
}

Rgb colour_at(double share, Colours colours) {
  const std::vector<Stop>& stops = stops_of(colours);
  std::size_t k = 1;
  while (k + 1 < stops.size() && share > stops[k].at) ++k;
  const double within = (share - stops[k - 1].at) / (stops[k].at - stops[k - 1].at);
  Rgb made{};
  for (std::size_t part = 0; part < 3; ++part)
    made[part] = static_cast<std::uint8_t>(
        std::lround((1.0 - within) * stops[k - 1].colour[part] + within * stops[k].colour[part]));
  return made;
}

std::vector<Rgb> table_of_colours(Colours colours) {
  std::vector<Rgb> table;
  for (const double light : {1.0, 0.6})
    for (std::size_t k = 0; k < shades; ++k) {
      Rgb one = colour_at(static_cast<double>(k) / (shades - 1), colours);
      for (std::uint8_t& part : one) part = static_cast<std::uint8_t>(light * part);
      table.push_back(one);
    }
  table.push_back({255, 255, 255});
  return table;
}

double share_of(const Axis& scale, double value) {
  const double share = scale.logarithmic ? std::log(value / scale.from) / std::log(scale.to / scale.from)
                                         : (value - scale.from) / (scale.to - scale.from);
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::vector<double> lines_of(const Axis& scale) {
  std::vector<double> lines;
  for (const Tick& tick : ticks_of(scale)) {
    if (!scale.logarithmic && !lines.empty()) lines.push_back(0.5 * (lines.back() + tick.at));
    lines.push_back(tick.at);
  }
  return lines;
}

IndexedPicture coloured(const FieldOnGrid& field, const Axis& scale, Colours colours,
                        const std::vector<double>& lines) {
  IndexedPicture picture{field.x.values.size(), field.y.values.size(), table_of_colours(colours), {}};
  // The number of lines of equal value that lie below a value. A plateau exactly at a tick counts as above the tick
  // everywhere, so that rounding does not draw a line through it.
  const double above = scale.logarithmic ? 0.0 : 2e-3 * (scale.to - scale.from);
  const auto band = [&](std::size_t i, std::size_t j) {
    return std::ranges::upper_bound(lines, field.at(i, j) + above);
  };
  picture.points.resize(picture.width * picture.height);
  for (std::size_t row = 0; row < picture.height; ++row)
    for (std::size_t i = 0; i < picture.width; ++i) {
      const std::size_t j = picture.height - 1 - row;
      const double value = field.at(i, j);
      const bool edge =
          (i + 1 < picture.width && band(i, j) != band(i + 1, j)) || (j > 0 && band(i, j) != band(i, j - 1));
      const auto shade = static_cast<std::size_t>(std::lround(share_of(scale, value) * (shades - 1)));
      picture.points[row * picture.width + i] =
          static_cast<std::uint8_t>(std::isfinite(value) ? shade + (edge ? shades : 0) : no_number);
    }
  return picture;
}

IndexedPicture colour_scale(Colours colours) {
  IndexedPicture picture{1, shades, table_of_colours(colours), {}};
  for (std::size_t row = 0; row < shades; ++row) picture.points.push_back(static_cast<std::uint8_t>(shades - 1 - row));
  return picture;
}

FieldOnGrid drawn_part(const FieldOnGrid& field, const Window& window, std::size_t width) {
  const double shape = (window.top - window.bottom) / (window.right - window.left);
  const auto height = static_cast<std::size_t>(std::lround(static_cast<double>(width) * std::clamp(shape, 0.33, 1.4)));
  // The centres of the points of the picture.
  const auto middles = [](double from, double to, std::size_t count) {
    const double half = 0.5 * (to - from) / static_cast<double>(count);
    return spaced(from + half, to - half, count);
  };
  return on_lines(field, middles(window.left, window.right, width), middles(window.bottom, window.top, height));
}

}  // namespace ehl::program
