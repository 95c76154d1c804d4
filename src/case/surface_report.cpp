// The printed lines about surfaces that are not smooth.
#include <fmt/core.h>

#include <cmath>

#include "base/text_format.hpp"
#include "case/surface_input.hpp"
#include "core/constants.hpp"
#include "surface/resample.hpp"

namespace ehl::program {
namespace {

/// Share of a map's variance that a mesh may lose without a warning.
constexpr double worth_a_word = 0.1;

// The length in SI, if it is known, followed by the dimensionless number.
std::string both(const std::string& own, double metres) {
  return std::isfinite(metres) ? length(metres) + " (" + own + ")" : own;
}
std::string height_text(double H, const Physics& physics) {
  return both(fmt::format("{:.4g}", H), physics.si ? H * physics.si->hertz.h_scale : std::nan(""));
}
std::string length_text(double X, const Physics& physics) {
  return both(fmt::format("{:.4g} a", X), physics.si ? X * physics.si->hertz.a : std::nan(""));
}

std::string text(const surface::Feature& feature, const Physics& physics) {
  return fmt::format(
      "height {}, width {}, at ({:.4g}, {:.4g}) a{}", height_text(feature.height, physics),
      length_text(feature.width, physics), feature.X, feature.Y,
      feature.angle != 0.0 ? fmt::format(", turned by {:.4g} degrees", feature.angle * 180.0 / core::pi) : "");
}

std::string text(const surface::HeightMap& map, const MapRecord& record, const Physics& physics,
                 const core::Grid& grid) {
  const surface::Resolution left = surface::resolution(map, grid);
  std::string text = fmt::format(
      "{}, {} x {} points on {:.4g} x {:.4g} a around ({:.4g}, {:.4g}) a; {}{} (taken away: mean {:.4g}, slopes "
      "{:.3g} and {:.3g} per point, in the file's unit), Sq {}, Sa {}, tapered over {:.3g} of its length at each "
      "edge; ",
      record.file, map.gap.nx, map.gap.ny, map.length_x(), map.length_y(), map.X, map.Y,
      record.filled > 0 ? fmt::format("{} missing points filled from their neighbours; ", record.filled) : "",
      record.plane_taken ? "levelled" : "without its mean", record.plane.mean, record.plane.slope_x,
      record.plane.slope_y, height_text(record.rms, physics), height_text(record.mean, physics), record.taper);
  if (record.longest_wave > 0.0 || record.shortest_wave > 0.0)
    text += fmt::format("Gaussian filter: waves{}{} taken away, Sq {} before; ",
                        record.longest_wave > 0.0 ? " longer than " + length_text(record.longest_wave, physics) : "",
                        record.shortest_wave > 0.0 ? (record.longest_wave > 0.0 ? " and" : "") +
                                                         (" shorter than " + length_text(record.shortest_wave, physics))
                                                   : "",
                        height_text(record.rms_levelled, physics));
  return text + fmt::format("on this mesh {} of its variance lost, no wave shorter than {} along x, {} along y",
                            percent(left.variance_lost), length_text(left.shortest_wave_X, physics),
                            length_text(left.shortest_wave_Y, physics));
}

}  // namespace

std::vector<std::string> surface_lines(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid) {
  std::vector<std::string> lines;
  for (const CarriedSurface* one : carried(surfaces)) {
    const auto* map = std::get_if<surface::HeightMap>(&one->relief);
    lines.push_back(
        one->section + ": " + one->shape + ", " +
        (map ? text(*map, *one->map, physics, grid) : text(std::get<surface::Feature>(one->relief), physics)));
  }
  return lines;
}

std::string surface_report(const SurfaceInput& surfaces, const Physics& physics, const core::Grid& grid) {
  const std::string next = "\n" + std::string(13, ' ');
  std::string text;
  for (std::string line : surface_lines(surfaces, physics, grid)) {
    const std::size_t colon = line.find(": ");
    line.replace(colon, 2, std::string(13 - colon, ' '));
    for (std::size_t at = line.find("; "); at != std::string::npos; at = line.find("; ", at)) line.replace(at, 2, next);
    text += line + "\n";
  }
  return text;
}

core::Warnings surface_warnings(const SurfaceInput& surfaces, const core::Grid& grid) {
  core::Warnings warnings;
  for (const CarriedSurface* one : carried(surfaces)) {
    const auto* map = std::get_if<surface::HeightMap>(&one->relief);
    if (!map) continue;
    const surface::Resolution left = surface::resolution(*map, grid);
    if (left.variance_lost > worth_a_word)
      warnings.push_back({"map-lost", "the mesh loses " + percent(left.variance_lost) +
                                          " of the variance of the map on " + one->section +
                                          ": its waves are too short for the mesh; use more cells"});
  }
  return warnings;
}

}  // namespace ehl::program
