#include "report/moving_surfaces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/si_units.hpp"
#include "contact/ellipse.hpp"
#include "surface/resample.hpp"

namespace ehl::program {
namespace {

// "0.5 a/u_m", "0.1345 ms": a time as the deck gives its own.
std::string in_unit_of_deck(const Case& input, double T) {
  const std::optional<SiScales> si = si_scales(input.physics);
  if (!si || !input.transient->in_seconds) return fmt::format("{:.4g} a/u_m", T);
  return fmt::format("{:.4g} ms", 1e3 * si->time * T);
}

// Warns of a feature or a map whose front is still upstream of the contact when the run in time ends.
void warn_of_late(const Case& input, const CarriedSurface& one, core::Warnings& warnings) {
  const auto* feature = std::get_if<surface::Feature>(&one.relief);
  if (feature && feature->angle != 0.0) return;  // an oblique feature reaches the contact at some Y
  const double inlet = -contact::extent(input.scene.contact.shape).X;
  const double ahead = feature ? feature->width : 0.5 * std::get<surface::HeightMap>(one.relief).length_x();
  const Travel travel = travel_of(one, *input.transient);
  if (travel.farthest + ahead >= inlet) return;
  const double arrival = time_to_move(one, *input.transient, inlet - ahead - travel.from);
  const std::string remedy = std::isnan(arrival)
                                 ? "it does not move towards the contact: choose x closer to it, or another speed"
                                 : "it would at time " + in_unit_of_deck(input, arrival) +
                                       ": give a longer end_time, or x closer to the contact";
  warnings.push_back({"late-feature", fmt::format("{} on {} does not reach the contact: its centre is at x = {:.4g} a "
                                                  "at time 0 and at x = {:.4g} a at the end, {}; {}",
                                                  one.shape, one.section, travel.from, travel.to,
                                                  in_unit_of_deck(input, input.transient->parameters.end), remedy)});
}

/// Cells per wave that a moving surface needs: with fewer the film loses its amplitude. [bench: waviness_in_rolling]
constexpr double cells_of_a_wave = 30.0;

// The share of the variance of a map in waves with fewer cells than they need: averaging over half of a wave removes
// it.
double variance_of_short_waves(const surface::HeightMap& map, core::Grid grid, double cells_times) {
  const double wider = 0.5 * cells_of_a_wave / cells_times;
  grid.nx = std::max(1, static_cast<int>(std::lround(grid.nx / wider)));
  grid.ny = std::max(1, static_cast<int>(std::lround(grid.ny / wider)));
  return surface::resolution(map, grid).variance_lost;
}

// Warns of a moving map, half of whose variance lies in waves that are too short for the mesh.
void warn_of_short_waves(const Case& input, const CarriedSurface& one, core::Warnings& warnings) {
  constexpr double most = 0.5;
  constexpr int most_doublings = 5;
  const auto* map = std::get_if<surface::HeightMap>(&one.relief);
  if (!map) return;
  const core::Grid& grid = input.scene.grid;
  const double share = variance_of_short_waves(*map, grid, 1.0);
  if (share <= most) return;
  int times = 2;
  while (times < 1 << most_doublings && variance_of_short_waves(*map, grid, times) > most) times *= 2;
  warnings.push_back(
      {"short-waves",
       fmt::format(
           "{:.0f} % of the variance of the map on {} lies in waves of fewer than {:g} cells, and their "
           "amplitude in a moving film depends on the mesh: use at least {} cells, or [{}] shortest_wave = {:.3g}",
           100.0 * share, one.section, cells_of_a_wave, times * grid.nx, one.section,
           cells_of_a_wave * grid.longest_step())});
}

// Warns of a moving feature on a mesh that is too coarse for it.
void warn_of_coarse(const Case& input, const CarriedSurface& one, core::Warnings& warnings) {
  const auto* feature = std::get_if<surface::Feature>(&one.relief);
  if (!feature) return;
  const core::Grid& grid = input.scene.grid;
  const bool waves = feature->shape == surface::Feature::Shape::waviness;
  const double wanted = waves ? cells_of_a_wave : 8.0;
  const double cells = feature->width / grid.longest_step();
  if (cells >= wanted) return;
  warnings.push_back(
      {"coarse-feature",
       fmt::format("{} on {} has {:.2g} cells across its {}, and a moving feature needs {:g}: its amplitude in the "
                   "film and its pressure depend on the mesh; use at least {:.0f} cells",
                   one.shape, one.section, cells, waves ? "wavelength" : "width", wanted,
                   std::ceil(grid.nx * wanted / cells))});
}

}  // namespace

core::Warnings moving_surface_warnings(const Case& input) {
  core::Warnings warnings;
  if (!input.transient) return warnings;
  for (const CarriedSurface* one : carried(input.surfaces)) warn_of_late(input, *one, warnings);
  for (const CarriedSurface* one : carried(input.surfaces)) warn_of_coarse(input, *one, warnings);
  for (const CarriedSurface* one : carried(input.surfaces)) warn_of_short_waves(input, *one, warnings);
  return warnings;
}

}  // namespace ehl::program
