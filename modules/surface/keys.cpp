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
  return {
      .name = "shape",
      .words = {"dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"},
      .meaning =
          "Shape of this surface. S is what it adds to the gap, r the distance from its centre, d that from its line. "
          "dimple: S = height exp(-(r/width)^2). bump: the same, upwards. groove and ridge: as dimple and bump, with d "
          "instead of r. waviness: S = height cos(2 pi d/width), in time only behind its front at x. cavity: S = "
          "height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2). map: measured heights from a file. In time the "
          "shape moves with its surface. In a steady contact its surface must stand still; in a dry contact all do.",
      .source = "cavity: Mourier et al. 2006",
      .example = "dimple"};
}

std::vector<Key> size_keys() {
  const Key height{.name = "height",
                   .range = positive,
                   .meaning = "Height, depth or amplitude, in units of a^2/R like H.",
                   .needs = by_formula,
                   .example = "0.02"};
  const Key width{.name = "width",
                  .range = positive,
                  .meaning = "Width or wavelength, in Hertz radii a.",
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
       .meaning = "Angle between the line of a ridge, groove or wave and the y axis, in degrees. 0: transverse. 90: "
                  "longitudinal.",
       .needs = {.name = "shape", .words = {"ridge", "groove", "waviness"}}},
      {.name = "x",
       .default_note = "steady: 0; in time upstream of the inlet, by three widths, one wave or half of a map",
       .range = {-1e3, 1e3},
       .meaning = "Position x of the centre at time 0, in Hertz radii. For a waviness: of a crest of the gap, in time "
                  "of the first one.",
       .example = "-3"},
      {.name = "y", .default_text = "0", .range = {-1e3, 1e3}, .meaning = "Position y of the centre, in Hertz radii."},
      {.name = "at_rest",
       .words = {"yes"},
       .meaning = "States that this surface stands still and the other one moves, in a steady contact given by M and L "
                  "or by W, U and G. In a contact in SI, set u1 = 0 or u2 = 0 instead.",
       .example = "yes"},
  };
}

std::vector<Key> map_keys() {
  const Key unit{.name = "unit",
                 .range = positive,
                 .meaning =
                     "Height that the number 1 in the file stands for, in units of a^2/R like H. With unit_m: 1e-9 for "
                     "a file in nanometres. Not needed if the file states its unit.",
                 .example = "0.01"};
  const Key dx{
      .name = "dx",
      .range = positive,
      .meaning = "Distance between two points of a line of the file, in Hertz radii. Not needed if the file states it.",
      .example = "0.02"};
  const Key dy{.name = "dy",
               .default_note = "that of the file, else dx",
               .range = positive,
               .meaning = "Distance between two lines of the file, in Hertz radii.",
               .example = "0.02"};
  const Key longest_wave{.name = "longest_wave",
                         .range = positive,
                         .meaning =
                             "Cut-off wavelength in Hertz radii of a Gaussian filter that removes longer waves. A wave "
                             "of this length keeps half of its height. Without this key no long waves are removed.",
                         .source = "ISO 16610-61",
                         .example = "8"};
  const Key shortest_wave{.name = "shortest_wave",
                          .range = positive,
                          .meaning =
                              "Cut-off wavelength in Hertz radii of a Gaussian filter that removes shorter waves. "
                              "Without this key no short waves are removed.",
                          .source = "ISO 16610-61",
                          .example = "0.2"};
  return {
      {.name = "levelling",
       .default_text = "plane",
       .words = {"plane", "mean"},
       .meaning = "What is subtracted from a map first. plane: the plane of least squares, which contains the tilt in "
                  "the instrument. mean: the mean height alone."},
      longest_wave,
      in_SI(longest_wave, "_m", "m", "8e-4"),
      shortest_wave,
      in_SI(shortest_wave, "_m", "m", "2.5e-6"),
      {.name = "file",
       .type = Type::text,
       .meaning =
           "File with the measured heights, positive out of the body, searched in the working folder, then beside the "
           "deck. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers "
           "separated by semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, "
           "the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in "
           "ASCII. A first line of words is a heading, # begins a comment. A .sur of Digital "
           "Surf. HDF5 (.h5): a dataset with rows of constant "
           "y. At least 8 by 8 points. Up to a fifth of them may be missing (an empty cell, NaN, BAD, ***); they are "
           "filled from their neighbours. The map is levelled, and averaged over the cells of the mesh.",
       .source = "modules/surface/README.md",
       .example = "heights.csv",
       .names = deck::Names::file},
      {.name = "dataset",
       .type = Type::text,
       .default_text = "height",
       .meaning = "Name of the dataset in a .h5 file."},
      unit,
      in_SI(unit, "_m", "m", "1e-9"),
      dx,
      in_SI(dx, "_m", "m", "1e-6"),
      dy,
      in_SI(dy, "_m", "m", "1e-6"),
      {.name = "taper",
       .default_text = "0.1",
       .range = {0.0, 0.5},
       .meaning = "Share of the map's length over which the heights fall to zero at each edge, by a cosine. 0: the map "
                  "ends in a step."},
  };
}

// A required length of a surface.
double length_of(const deck::Part& surface, const std::string& name, const deck::PlainUnit& unit) {
  if (surface.given_of({name, name + unit.suffix}).empty())
    surface.complain(name, "is missing: give it, or " + name + unit.suffix + " for a contact in SI",
                     deck::Cause::missing);
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
  if (map.file.empty())
    surface.complain("file", "is missing: give the measured heights, a text file or a .h5", deck::Cause::missing);
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
