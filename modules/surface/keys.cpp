#include "surface/keys.hpp"

#include <cmath>
#include <numbers>

#include "deck/record.hpp"

namespace ehl::surface {
namespace {

const deck::Condition by_formula{.name = "shape", .words = {"dimple", "bump", "ridge", "groove", "waviness", "cavity"}};

deck::Records<Input> shape_records() {
  using namespace deck::record;
  return {
      key("shape", &Input::shape, words({"dimple", "bump", "ridge", "groove", "waviness", "cavity", "map"}),
          example("dimple"),
          "Shape of this surface. S is what it adds to the gap, r the distance from its centre, d that from its line. "
          "dimple: S = height exp(-(r/width)^2). bump: the same, upwards. groove and ridge: as dimple and bump, with d "
          "instead of r. waviness: S = height cos(2 pi d/width), in time only behind its front at x. cavity: S = "
          "height "
          "cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2). map: measured heights from a file. In time the shape moves "
          "with its surface. In a steady contact its surface must stand still; in a dry contact all do.",
          source("cavity: Mourier et al. 2006")),
      key("height", in_SI("_m", "m", "1e-7"), positive, by_formula,
          required("give it, or height_m for a contact in SI"), example("0.02"),
          "Height, depth or amplitude, in units of a^2/R like H."),
      key("width", in_SI("_m", "m", "2e-5"), positive, by_formula, required("give it, or width_m for a contact in SI"),
          example("0.25"), "Width or wavelength, in Hertz radii a."),
      key("angle", Range{-90.0, 90.0}, by_default("0"), needs("shape", {"ridge", "groove", "waviness"}),
          "Angle between the line of a ridge, groove or wave and the y axis, in degrees. 0: transverse. 90: "
          "longitudinal."),
      key("x", &Input::X, Range{-1e3, 1e3}, example("-3"),
          otherwise("steady: 0; in time upstream of the inlet, by three widths, one wave or half of a map"),
          "Position x of the centre at time 0, in Hertz radii. For a waviness: of a crest of the gap, in time of the "
          "first one."),
      key("y", &Input::Y, Range{-1e3, 1e3}, by_default("0"), "Position y of the centre, in Hertz radii."),
      key("at_rest", &Input::at_rest, {{"yes", true}}, example("yes"),
          "States that this surface stands still and the other one moves, in a steady contact given by M and L or by "
          "W, U and G. In a contact in SI, set u1 = 0 or u2 = 0 instead."),
  };
}

deck::Records<MapInput> map_records() {
  using namespace deck::record;
  return {
      key("levelling", &MapInput::plane, {{"plane", true}, {"mean", false}}, own_default,
          "What is subtracted from a map first. plane: the plane of least squares, which contains the tilt in the "
          "instrument. mean: the mean height alone."),
      key("longest_wave", in_SI("_m", "m", "8e-4"), positive, example("8"),
          "Cut-off wavelength in Hertz radii of a Gaussian filter that removes longer waves. A wave of this length "
          "keeps half of its height. Without this key no long waves are removed.",
          source("ISO 16610-61")),
      key("shortest_wave", in_SI("_m", "m", "2.5e-6"), positive, example("0.2"),
          "Cut-off wavelength in Hertz radii of a Gaussian filter that removes shorter "
          "waves. Without this key no short waves are removed.",
          source("ISO 16610-61")),
      key("file", &MapInput::file, file, required("give the measured heights, a text file or a .h5"),
          example("heights.csv"),
          "File with the measured heights, positive out of the body, searched in the working folder, then beside the "
          "deck. Text (.csv, .txt, .dat, .asc, .xyz, .sdf): lines along x, the first at the smallest y, numbers "
          "separated by semicolons, tabs, commas or blanks, with decimal points or commas; or x, y, z in every line, "
          "the points of a regular grid in any order; or Gwyddion's text, ESRI's ASCII grid, SDF of ISO 25178-71 in "
          "ASCII. A first line of words is a heading, # begins a comment. A .sur of Digital Surf. HDF5 (.h5): a "
          "dataset with rows of constant y. At least 8 by 8 points. Up to a fifth of them may be missing (an empty "
          "cell, NaN, BAD, ***); they are filled from their neighbours. The map is levelled, and averaged over the "
          "cells of the mesh.",
          source("modules/surface/README.md")),
      key("dataset", &MapInput::dataset, by_default("height"), "Name of the dataset in a .h5 file."),
      key("unit", in_SI("_m", "m", "1e-9"), positive, example("0.01"),
          "Height that the number 1 in the file stands for, in units of a^2/R like H. With unit_m: "
          "1e-9 for a file in nanometres. Not needed if the file states its unit."),
      key("dx", in_SI("_m", "m", "1e-6"), positive, example("0.02"),
          "Distance between two points of a line of the file, in Hertz radii. Not needed if the file states it."),
      key("dy", in_SI("_m", "m", "1e-6"), positive, example("0.02"), otherwise("that of the file, else dx"),
          "Distance between two lines of the file, in Hertz radii."),
      key("taper", &MapInput::taper, Range{0.0, 0.5}, by_default("0.1"),
          "Share of the map's length over which the heights fall to zero at each edge, by a cosine. 0: the map ends in "
          "a step."),
  };
}

deck::Records<Input> of_shapes() { return deck::only_with<Input>({.name = "shape"}, shape_records()); }

deck::Records<MapInput> of_maps() {
  return deck::only_with<MapInput>({.name = "shape", .words = {"map"}}, map_records());
}

Feature read_feature(const deck::Part& surface, const Units& units) {
  using enum Feature::Shape;
  Feature feature;
  feature.shape = surface.choice("shape", {dimple, bump, ridge, groove, waviness, cavity});
  feature.height = surface.number_in("height", units.height);
  feature.width = surface.number_in("width", units.a);
  const double angle = surface.number("angle");
  feature.angle = std::isnan(angle) ? 0.0 : angle * std::numbers::pi / 180.0;
  return feature;
}

MapInput read_map(const deck::Part& surface, const Units& units) {
  MapInput map = deck::read(surface, of_maps());
  map.unit = surface.number_in("unit", units.height);
  map.dx = surface.number_in("dx", units.a);
  map.dy = surface.number_in("dy", units.a);
  const auto wave = [&](const char* name) {
    const double length = surface.number_in(name, units.a);
    return std::isnan(length) ? 0.0 : length;
  };
  map.longest_wave = wave("longest_wave");
  map.shortest_wave = wave("shortest_wave");
  return map;
}

}  // namespace

std::vector<deck::Key> keys() {
  std::vector<deck::Key> all;
  for (const char* section : {"surface1", "surface2"})
    all = deck::together({all, deck::keys_of(section, of_shapes()), deck::keys_of(section, of_maps())});
  return all;
}

Input read(deck::Deck& deck, const std::string& section, const Units& units) {
  const deck::Part surface{deck, section};
  Input input = deck::read(surface, of_shapes());
  if (input.shape == "map")
    input.map = read_map(surface, units);
  else if (!input.shape.empty())
    input.feature = read_feature(surface, units);
  return input;
}

}  // namespace ehl::surface
