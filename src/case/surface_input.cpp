#include "case/surface_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "case/map_file.hpp"
#include "core/norms.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "steady/scales.hpp"
#include "surface/gaussian_filter.hpp"
#include "surface/keys.hpp"

namespace ehl::program {
namespace {

using deck::given;
using surface::Feature;

/// A surface speed below this share of u_m is zero: with srr = 2, u_m (1 - srr/2) is zero up to rounding.
constexpr double no_speed = 1e-12;
/// Heights that remain after levelling are rounding if they are below this share of the original heights.
constexpr double no_heights = 1e-12;
/// A feature has no influence if it changes the gap at the nodes by less than this share of its height.
constexpr double no_influence = 1e-9;

// The place of a feature; chosen if the deck leaves it open. in: before: distance from the inlet at
// which a moving feature starts.
double place_of(const deck::Part& surface, double X, const core::Grid& grid, double before, bool timed) {
  if (!std::isnan(X) || !std::isfinite(before)) return X;
  const double chosen = timed ? grid.X_a - before : 0.0;
  surface.fill("x", chosen, timed ? "upstream of the inlet" : "in the middle of the contact");
  return chosen;
}

CarriedSurface feature_of(const deck::Part& part, const surface::Input& input, const core::Grid& grid, bool timed) {
  Feature feature = *input.feature;
  feature.front = timed;
  const double widths = feature.shape == Feature::Shape::waviness ? 1.0 : 3.0;
  feature.X = place_of(part, input.X, grid, widths * feature.width, timed);
  feature.Y = input.Y;
  if (grid.ny > 0 && feature.width < 4.0 * grid.hx())
    part.complain(
        part.given("width") ? "width" : "width_m",
        fmt::format(
            "is {:.4g} Hertz radii, less than four cells of {:.4g}: the grid does not resolve it; use more cells",
            feature.width, grid.hx()));
  return {part.section, input.shape, feature, std::nullopt};
}

// Detects a wrong spacing or unit of a map. in: expected: film of smooth surfaces, in a^2/R; NaN: not known.
void check_meant(const deck::Part& part, const surface::HeightMap& map, const core::Grid& grid, double rms,
                 double expected) {
  constexpr double fewest_cells = 8.0, most_domains = 100.0, most_films = 100.0;
  const double x = map.length_x(), y = map.length_y(), X = grid.X_b - grid.X_a, Y = grid.Y_b - grid.Y_a;
  const auto complain = [&](const char* key, const std::string& in_SI, const std::string& what) {
    part.complain(part.given(key) ? key : key + in_SI, what + ": check the unit");
  };
  if (grid.ny > 0 && (x < fewest_cells * grid.hx() || y < fewest_cells * grid.hy()))
    complain("dx", "_m",
             fmt::format("gives a map of {:.3g} x {:.3g} Hertz radii, less than 8 cells of {:.3g} x {:.3g}", x, y,
                         grid.hx(), grid.hy()));
  if (x > most_domains * X || y > most_domains * Y)
    complain(
        "dx", "_m",
        fmt::format("gives a map of {:.3g} x {:.3g} Hertz radii, more than 100 times the domain of {:.3g} x {:.3g}", x,
                    y, X, Y));
  if (rms > most_films * expected)
    complain(
        "unit", "_m",
        fmt::format(
            "gives heights of Sq = {:.3g} a^2/R, more than 100 times the film predicted for smooth surfaces, {:.3g}",
            rms, expected));
}

/// Relative difference between file and deck that counts as equal.
constexpr double same = 0.01;

// A length of the map in its plain unit: the value of the deck, else the value that the file states in metres. in: name
// of the key; given: its value, NaN: not given; stated: the value of the file, NaN: not stated; plain: the plain unit
// in metres, NaN: not known.
double settled(const deck::Part& part, const std::string& name, double given, double stated, double plain) {
  const std::string key = part.given(name) ? name : name + "_m";
  if (!part.given_of({name, name + "_m"}).empty()) {
    if (std::isfinite(stated) && std::isfinite(plain) && std::abs(given * plain / stated - 1.0) > same)
      part.complain(key,
                    fmt::format("is {:.6g} m, but the file states {:.6g} m: remove the key, or correct one of them",
                                given * plain, stated));
    return given;
  }
  if (std::isnan(stated))
    part.complain(name, "is missing, and the file does not state it: give it, or " + name + "_m for a contact in SI",
                  deck::Cause::missing);
  else if (std::isnan(plain))
    part.complain(name, fmt::format("is missing: the file states {:.6g} m, but the contact is not given in SI", stated),
                  deck::Cause::missing);
  return stated / plain;
}

// Combines the lengths stated by the file and by the deck.
void settle_lengths(const deck::Part& part, const MapInFile& file, const surface::Units& units,
                    surface::MapInput& input) {
  input.unit = settled(part, "unit", input.unit, file.unit_m, units.height.in_SI);
  input.dx = settled(part, "dx", input.dx, file.dx_m, units.a.in_SI);
  const bool known = !part.given_of({"dy", "dy_m"}).empty() || std::isfinite(file.dy_m / units.a.in_SI);
  input.dy = known ? settled(part, "dy", input.dy, file.dy_m, units.a.in_SI) : input.dx;
  if (input.longest_wave > 0.0 && input.longest_wave <= input.shortest_wave)
    part.complain(part.given("longest_wave") ? "longest_wave" : "longest_wave_m",
                  "must be longer than shortest_wave: otherwise no wave is left");
  const double reach = std::min(input.dx, input.dy);
  if (input.shortest_wave > 0.0 && input.shortest_wave < reach)
    part.complain(
        part.given("shortest_wave") ? "shortest_wave" : "shortest_wave_m",
        fmt::format("has no influence: it is {:.4g} Hertz radii, less than the distance between the points, {:.4g}",
                    input.shortest_wave, reach),
        deck::Cause::idle);
}

// Removes the mean plane and applies the filters. out: heights in units of the file.
void condition(const surface::MapInput& input, surface::Heights& heights, MapRecord& record) {
  record.plane_taken = input.plane;
  record.plane = input.plane ? surface::level(heights) : surface::level_mean(heights);
  record.rms_levelled = input.unit * surface::rms(heights);
  record.longest_wave = input.longest_wave;
  record.shortest_wave = input.shortest_wave;
  if (input.longest_wave > 0.0) {
    const surface::Heights longer = surface::long_waves(heights, input.dx, input.dy, input.longest_wave);
    for (std::size_t n = 0; n < longer.values.size(); ++n) heights.values[n] -= longer.values[n];
  }
  if (input.shortest_wave > 0.0) heights = surface::long_waves(heights, input.dx, input.dy, input.shortest_wave);
}

// Reads a map; nothing if it has errors.
std::optional<CarriedSurface> map_of(const deck::Part& part, surface::Input& input, const core::Grid& grid, bool timed,
                                     double expected, const surface::Units& units) {
  if (input.map->file.empty()) return std::nullopt;
  if (const std::string key = "Sq" + part.section.substr(7); given(part.deck, "contact", key))
    deck::complain(part.deck, "contact", key,
                   "the map of " + part.section + " contains the roughness of this surface: remove this key");
  ReadHeights read = read_heights(deck::found_beside(part.deck, part.section, "file"), input.map->dataset,
                                  input.map->dx * units.a.in_SI);
  if (const auto* wrong = std::get_if<std::string>(&read)) part.complain("file", *wrong);
  if (!part.deck.errors.empty()) return std::nullopt;
  MapInFile& file = std::get<MapInFile>(read);
  settle_lengths(part, file, units, *input.map);
  if (!part.deck.errors.empty()) return std::nullopt;
  surface::HeightMap map{.gap = std::move(file.heights), .dx = input.map->dx, .dy = input.map->dy};
  MapRecord record{.file = input.map->file, .filled = file.filled, .taper = input.map->taper};
  const double before = std::ranges::max(map.gap.values, {}, [](double z) { return std::abs(z); });
  condition(*input.map, map.gap, record);
  const double left = surface::rms(map.gap);
  if (!(left > no_heights * std::abs(before))) {
    part.complain("file", record.file + ": the map is flat: no heights are left after levelling");
    return std::nullopt;
  }
  for (double& z : map.gap.values) z *= -input.map->unit;
  record.rms = input.map->unit * left;
  record.mean = surface::mean_height(map.gap);
  surface::taper(map.gap, record.taper);
  map.X = place_of(part, input.X, grid, 0.5 * map.length_x(), timed);
  map.Y = input.Y;
  map.step = std::max(map.dx, grid.hx());
  check_meant(part, map, grid, record.rms, expected);
  return CarriedSurface{part.section, input.shape, std::move(map), std::move(record)};
}

// In a steady film every surface must look the same at all times: a surface that is not smooth must be at rest.
void check_at_rest(const deck::Part& part, const Physics& physics, bool timed) {
  const bool said = part.given("at_rest");
  if (timed) {
    if (said)
      part.complain(
          "at_rest",
          "is available for steady contacts only: in time, u1 and u2 of [transient] give the motion of the surface");
  } else if (physics.language == contact::Language::si) {
    if (said)
      part.complain("at_rest", "has no influence: [motion] states which surface stands still; remove it",
                    deck::Cause::idle);
    if (!physics.si) return;  // the error was reported already
    const double u = part.section == "surface1" ? physics.si->u1 : physics.si->u2;
    if (std::abs(u) > no_speed * physics.si->contact.u_s)
      part.complain(
          "shape",
          "is on a surface that moves with " + deck::shortest(u) +
              " m/s, so the film is not steady: give [transient] end_time, or let this surface stand still (u" +
              part.section.back() + " = 0 in [motion])");
  } else if (!said) {
    part.complain(
        "shape",
        "moves through the contact and needs [transient] end_time; if this surface stands still, set at_rest = yes");
  }
}

void check_influence(const deck::Part& part, const surface::Relief& relief, const core::Grid& grid) {
  if (grid.ny == 0) return;
  core::Field S(grid);
  surface::add_cell_average(relief, grid, S);
  const auto* map = std::get_if<surface::HeightMap>(&relief);
  const double height = map ? surface::rms(map->gap) : std::get<Feature>(relief).height;
  if (core::max_abs(S) > no_influence * height) return;
  const auto [X, Y] = std::visit([](const auto& one) { return std::pair(one.X, one.Y); }, relief);
  part.complain("shape",
                "has no influence: centred at (" + deck::shortest(X) + ", " + deck::shortest(Y) +
                    ") a, it does not reach into the domain",
                deck::Cause::idle);
}

std::optional<CarriedSurface> carried_by(const deck::Part& part, const Physics& physics, const core::Grid& grid,
                                         Motion motion) {
  const bool timed = motion == Motion::in_time;
  surface::Units units;
  // An error in a contact in SI was reported already.
  units.a.known = units.height.known = physics.language == contact::Language::si || given(part.deck, "contact", "load");
  if (physics.si) {
    units.a.in_SI = physics.si->hertz.a;
    units.height.in_SI = physics.si->hertz.h_scale;
  }
  surface::Input input = surface::read(part.deck, part.section, units);
  if (input.shape.empty()) return std::nullopt;
  if (motion != Motion::dry) check_at_rest(part, physics, timed);
  const double expected = steady::scales_of(physics.groups.M, physics.groups.L, physics.groups.shape).film;
  std::optional<CarriedSurface> surface =
      input.map ? map_of(part, input, grid, timed, expected, units) : feature_of(part, input, grid, timed);
  if (!timed && surface && part.deck.errors.empty()) check_influence(part, surface->relief, grid);
  return surface;
}

}  // namespace

SurfaceInput surface_input(deck::Deck& deck, const Physics& physics, const core::Grid& grid, Motion motion) {
  SurfaceInput surfaces{carried_by({deck, "surface1"}, physics, grid, motion),
                        carried_by({deck, "surface2"}, physics, grid, motion)};
  if (given(deck, "surface1", "at_rest") && given(deck, "surface2", "at_rest"))
    deck::complain(deck, "surface2", "at_rest", "cannot hold for both surfaces: no oil would enter the contact");
  return surfaces;
}

std::vector<const CarriedSurface*> carried(const SurfaceInput& surfaces) {
  std::vector<const CarriedSurface*> all;
  for (const auto* surface : {&surfaces.on_1, &surfaces.on_2})
    if (*surface) all.push_back(&**surface);
  return all;
}

void let_stand(const SurfaceInput& surfaces, steady::Scene& scene) {
  std::vector<surface::Relief> all;
  for (const CarriedSurface* surface : carried(surfaces)) all.push_back(surface->relief);
  if (all.empty()) return;
  scene.use_symmetry =
      scene.use_symmetry && std::ranges::all_of(all, [](const auto& one) { return surface::symmetric(one); });
  // Scenes are copied; the copies share the maps.
  const auto shared = std::make_shared<const std::vector<surface::Relief>>(std::move(all));
  scene.surface = [shared](const core::Patch& grid, core::Field& S) {
    S.fill(0.0);
    for (const surface::Relief& relief : *shared) surface::add_cell_average(relief, grid, S);
  };
}

}  // namespace ehl::program
