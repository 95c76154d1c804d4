#include "surface/keys.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace ehl::surface {
namespace {

using deck::Key;
using deck::Type;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr deck::Range positive{0.0, infinity, true, true};
const deck::Condition by_formula{.name = "shape", .words = {"dimple", "bump", "ridge", "groove", "waviness", "cavity"}};

Key shape_key() {
  return {.name = "shape",
          .words = {"dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"},
          .meaning =
              "What this surface carries, S being what the gap gains, r and d the distances from its middle "
              "and its line: dimple height exp(-(r/width)^2), bump the same upwards, groove and ridge "
              "likewise with d, waviness height cos(2 pi d/width), in time behind its front at x, cavity "
              "height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2); map: measured heights from a file. In "
              "time it moves with its surface; in a steady contact it must be on a surface that stands still, "
              "in a dry one all do.",
          .source = "cavity: Mourier et al. 2006",
          .example = "dimple"};
}

std::vector<Key> size_keys() {
  const Key height{.name = "height",
                   .range = positive,
                   .meaning = "Height (or depth, or amplitude) in units of a^2/R, as H.",
                   .needs = by_formula,
                   .example = "0.02"};
  const Key width{.name = "width",
                  .range = positive,
                  .meaning = "Width, or wavelength, in Hertz radii a.",
                  .needs = by_formula,
                  .example = "0.25"};
  return {
      height,
      in_SI(height, "_m", "m", "1e-7"),
      width,
      in_SI(width, "_m", "m", "2e-5"),
      {.name = "angle",
       .default_text = "0",
       .range = {-90.0, 90.0},
       .meaning = "Degrees between the line of a ridge, groove or wave and the y axis: 0 transverse, 90 longitudinal.",
       .needs = {.name = "shape", .words = {"ridge", "groove", "waviness"}}},
      {.name = "x",
       .default_note = "in time before the inlet, by three widths, by one wave, by half of a map; steady 0",
       .range = {-1e3, 1e3},
       .meaning = "Where its middle (of waves: a crest of the gap, in time the first) is at time 0, in Hertz radii.",
       .example = "-3"},
      {.name = "y",
       .default_text = "0",
       .range = {-1e3, 1e3},
       .meaning = "Where its middle is across the entrainment."},
      {.name = "at_rest",
       .words = {"yes"},
       .meaning = "Says of a steady contact given by M and L, or W, U and G, that it is this surface that stands "
                  "still and the other one that moves. A contact in SI says it with u1 = 0 or u2 = 0.",
       .example = "yes"},
  };
}

std::vector<Key> map_keys() {
  const Key unit{.name = "unit",
                 .range = positive,
                 .meaning =
                     "Height of the number 1 in the file, in units of a^2/R, as H; unit_m = 1e-9 where the file is in "
                     "nanometres. May be left out where the file states its unit.",
                 .example = "0.01"};
  const Key dx{.name = "dx",
               .range = positive,
               .meaning =
                   "Distance between two points of a line of the file, in Hertz radii. May be left out where "
                   "the file states it.",
               .example = "0.02"};
  const Key dy{.name = "dy",
               .default_note = "that of the file, or of dx",
               .range = positive,
               .meaning = "Distance between two lines of the file, in Hertz radii.",
               .example = "0.02"};
  const Key longest_wave{.name = "longest_wave",
                         .range = positive,
                         .meaning =
                             "Cut-off wavelength, in Hertz radii, of a Gaussian filter that takes longer waves "
                             "away. A wave of this length keeps half of its height. Without it all long waves "
                             "stay.",
                         .source = "ISO 16610-61",
                         .example = "8"};
  const Key shortest_wave{
      .name = "shortest_wave",
      .range = positive,
      .meaning = "The same for shorter waves, which it takes away; without it all short waves stay.",
      .source = "ISO 16610-61",
      .example = "0.2"};
  return {
      {.name = "levelling",
       .default_text = "plane",
       .words = {"plane", "mean"},
       .meaning = "What is taken away of a map first: the plane of least squares, with the tilt under the instrument; "
                  "or its mean alone."},
      longest_wave,
      in_SI(longest_wave, "_m", "m", "8e-4"),
      shortest_wave,
      in_SI(shortest_wave, "_m", "m", "2.5e-6"),
      {.name = "file",
       .type = Type::text,
       .meaning =
           "The measured heights, counted from the body outwards. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines "
           "along x, the first at the smallest y, numbers between semicolons, tabs, commas or blanks, with decimal "
           "points or commas; or x, y, z in every line, the points of a regular grid in any order; or Gwyddion's "
           "text, ESRI's ASCII grid, SDF of ISO 25178-71 in ASCII. A first line of words is a heading, # begins a "
           "comment. Or a .h5 with a dataset in rows of constant y. At least 8 by 8 points; up to a fifth of them may "
           "be missing (an empty cell, NaN, BAD, ***) and is filled from its neighbours. It is looked for where the "
           "program runs, then beside the deck. It is levelled; onto the mesh it comes as means over the cells.",
       .source = "modules/surface/README.md",
       .example = "heights.csv",
       .names_file = true},
      {.name = "dataset", .type = Type::text, .default_text = "height", .meaning = "The dataset of a .h5."},
      unit,
      in_SI(unit, "_m", "m", "1e-9"),
      dx,
      in_SI(dx, "_m", "m", "1e-6"),
      dy,
      in_SI(dy, "_m", "m", "1e-6"),
      {.name = "taper",
       .default_text = "0.1",
       .range = {0.0, 0.5},
       .meaning = "Share of the map's length along which its heights come down to zero at each of its edges, by a "
                  "cosine; 0: they end as they are, in a step."},
  };
}

// A required length of a surface.
double length_of(const deck::Part& surface, const std::string& name, const deck::PlainUnit& unit) {
  if (surface.given_of({name, name + unit.suffix}).empty())
    surface.complain(name, "is missing: give it, or " + name + unit.suffix + " for a contact in SI");
  return surface.number_in(name, unit);
}

Feature read_feature(const deck::Part& surface, const Units& units) {
  using enum Feature::Shape;
  Feature feature;
  feature.shape = surface.choice("shape", {dimple, bump, ridge, groove, waviness, cavity});
  feature.height = length_of(surface, "height", units.height);
  feature.width = length_of(surface, "width", units.a);
  const double angle = surface.number("angle");
  feature.angle = std::isnan(angle) ? 0.0 : angle * std::numbers::pi / 180.0;
  return feature;
}

MapInput read_map(const deck::Part& surface, const Units& units) {
  MapInput map;
  map.unit = surface.number_in("unit", units.height);
  map.dx = surface.number_in("dx", units.a);
  map.dy = surface.number_in("dy", units.a);
  const auto wave = [&](const char* name) {
    const double length = surface.number_in(name, units.a);
    return std::isnan(length) ? 0.0 : length;
  };
  map.longest_wave = wave("longest_wave");
  map.shortest_wave = wave("shortest_wave");
  map.plane = surface.word("levelling") != "mean";
  map.file = surface.word("file");
  if (map.file.empty()) surface.complain("file", "is missing: the measured heights, a text file or a .h5");
  map.dataset = surface.word("dataset");
  map.taper = surface.number("taper");
  return map;
}

}  // namespace

std::vector<Key> keys() {
  const std::vector<Key> of_one =
      deck::together({deck::only_with({.name = "shape"}, deck::together({{shape_key()}, size_keys()})),
                      deck::only_with({.name = "shape", .words = {"map"}}, map_keys())});
  std::vector<Key> all;
  for (const char* section : {"surface1", "surface2"}) all = deck::together({all, deck::in_section(section, of_one)});
  return all;
}

Input read(deck::Deck& deck, const std::string& section, const Units& units) {
  const deck::Part surface{deck, section};
  Input input{.shape = surface.word("shape")};
  if (input.shape == "map")
    input.map = read_map(surface, units);
  else if (!input.shape.empty())
    input.feature = read_feature(surface, units);
  input.at_rest = !surface.word("at_rest").empty();
  input.X = surface.number("x");
  input.Y = surface.number("y");
  return input;
}

}  // namespace ehl::surface
