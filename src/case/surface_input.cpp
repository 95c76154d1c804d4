#include "case/surface_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "case/file_beside.hpp"
#include "case/map_file.hpp"
#include "core/norms.hpp"
#include "deck/text.hpp"
#include "report/text_format.hpp"

namespace ehl::program {
namespace {

using deck::complain;
using deck::given;
using surface::Feature;

/// A surface speed below this share of u_m is none: u_m (1 - srr/2) with srr = 2, but for rounding.
constexpr double no_speed = 1e-12;
/// Heights left of a map by levelling, over those that it came with, that are rounding.
constexpr double no_heights = 1e-12;
/// Largest gap on the grid, over the height of what makes it, that is no influence.
constexpr double no_influence = 1e-9;

struct Units {
  deck::PlainUnit a{.suffix = "_m"};       ///< Hertz radius
  deck::PlainUnit height{.suffix = "_m"};  ///< a^2/R
};

// One length of a surface, which it cannot do without.
double length_of(deck::Deck& deck, const std::string& of, const std::string& key, const deck::PlainUnit& unit) {
  if (!given(deck, of, key) && !given(deck, of, key + unit.suffix))
    complain(deck, of, key, "is missing: give it, or " + key + unit.suffix + " for a contact in SI");
  return deck::number_in(deck, of, key, unit);
}

struct Place {
  double X = 0.0;
  double Y = 0.0;
};

// in: how far before the inlet it begins where it moves.
Place place_of(deck::Deck& deck, const std::string& of, const core::Grid& grid, double before, bool timed) {
  if (!given(deck, of, "x") && std::isfinite(before))
    deck::choose(deck, of, "x", timed ? grid.X_a - before : 0.0, timed ? "before the inlet" : "in the middle");
  return {deck::number(deck, of, "x"), deck::number(deck, of, "y")};
}

Feature feature_of(deck::Deck& deck, const std::string& of, const Units& units, const core::Grid& grid, bool timed) {
  const std::string shape = deck::word(deck, of, "shape");
  using Shape = Feature::Shape;
  Feature feature;
  feature.shape = shape == "dimple"     ? Shape::dimple
                  : shape == "bump"     ? Shape::bump
                  : shape == "ridge"    ? Shape::ridge
                  : shape == "groove"   ? Shape::groove
                  : shape == "waviness" ? Shape::waviness
                                        : Shape::cavity;
  feature.height = length_of(deck, of, "height", units.height);
  feature.width = length_of(deck, of, "width", units.a);
  const double angle = deck::number(deck, of, "angle");
  feature.angle = std::isnan(angle) ? 0.0 : angle * std::numbers::pi / 180.0;
  feature.front = timed;
  const Place place = place_of(deck, of, grid, (shape == "waviness" ? 1.0 : 3.0) * feature.width, timed);
  feature.X = place.X;
  feature.Y = place.Y;
  if (grid.nx > 0 && feature.width < 4.0 * grid.hx())
    complain(deck, of, given(deck, of, "width") ? "width" : "width_m",
             formatted("is %.4g Hertz radii, fewer than four cells of %.4g", feature.width, grid.hx()) +
                 ": the mesh does not see it; use more cells");
  return feature;
}

// The spacing along y is that along x where the deck is silent.
double spacing_across(deck::Deck& deck, const std::string& of, const Units& units, double dx) {
  const double dy = deck::number_in(deck, of, "dy", units.a);
  return given(deck, of, "dy") || given(deck, of, "dy_m") ? dy : dx;
}

// Nothing where something was complained about.
std::optional<CarriedSurface> map_of(deck::Deck& deck, const std::string& of, const Units& units,
                                     const core::Grid& grid, bool timed) {
  surface::HeightMap map;
  const double unit = length_of(deck, of, "unit", units.height);
  map.dx = length_of(deck, of, "dx", units.a);
  map.dy = spacing_across(deck, of, units, map.dx);
  MapRecord record{.file = deck::word(deck, of, "file"), .taper = deck::number(deck, of, "taper")};
  if (record.file.empty()) {
    complain(deck, of, "file", "is missing: the measured heights, a .csv or a .h5");
    return std::nullopt;
  }
  ReadHeights read = read_heights(found_beside(deck, of, "file"), deck::word(deck, of, "dataset"));
  if (const auto* wrong = std::get_if<std::string>(&read)) {
    complain(deck, of, "file", *wrong);
    return std::nullopt;
  }
  if (!deck.errors.empty()) return std::nullopt;
  map.gap = std::move(std::get<surface::Heights>(read));
  const double before = std::ranges::max(map.gap.values, {}, [](double z) { return std::abs(z); });
  record.plane = surface::level(map.gap);
  const double left = surface::rms(map.gap);
  if (!(left > no_heights * std::abs(before))) {
    complain(deck, of, "file", record.file + ": its heights lie in a plane: without it nothing is left");
    return std::nullopt;
  }
  for (double& z : map.gap.values) z *= -unit;
  record.rms = unit * left;
  surface::taper(map.gap, record.taper);
  const Place place = place_of(deck, of, grid, 0.5 * map.length_x(), timed);
  map.X = place.X;
  map.Y = place.Y;
  map.step = std::max(map.dx, grid.hx());
  return CarriedSurface{of, "map", std::move(map), std::move(record)};
}

// A steady film is that of surfaces that look the same at all times: one that is not smooth must stand.
void check_at_rest(deck::Deck& deck, const std::string& of, const Physics& physics, bool timed) {
  const bool said = given(deck, of, "at_rest");
  if (timed) {
    if (said) complain(deck, of, "at_rest", "is for steady contacts: in time [transient] u1 and u2 say how it moves");
  } else if (physics.language == Language::si) {
    if (said) complain(deck, of, "at_rest", "has no influence: [motion] says which surface stands; remove it");
    if (!physics.si) return;  // complained about already
    const double u = of == "surface1" ? physics.si->u1 : physics.si->u2;
    if (std::abs(u) > no_speed * physics.si->contact.u_s)
      complain(deck, of, "shape",
               "is on a surface that moves with " + deck::shortest(u) +
                   " m/s, and the film is not steady: give [transient] end_time, or let this surface stand (u" +
                   of.back() + " = 0 in [motion])");
  } else if (!said) {
    complain(deck, of, "shape",
             "moves through the contact and needs [transient] end_time, unless this surface stands still: then say "
             "at_rest = yes");
  }
}

void check_influence(deck::Deck& deck, const CarriedSurface& surface, const core::Grid& grid) {
  if (grid.ny == 0) return;
  core::Field S(grid);
  surface::add_cell_average(surface.relief, grid, S);
  const auto* map = std::get_if<surface::HeightMap>(&surface.relief);
  const double height = map ? surface::rms(map->gap) : std::get<Feature>(surface.relief).height;
  if (core::max_abs(S) > no_influence * height) return;
  complain(deck, surface.section, "shape",
           "has no influence: where it stands, at (" + deck::shortest(deck::number(deck, surface.section, "x")) + ", " +
               deck::shortest(deck::number(deck, surface.section, "y")) + ") a, nothing of it lies in the domain");
}

std::optional<CarriedSurface> carried_by(deck::Deck& deck, const std::string& of, const Physics& physics,
                                         const core::Grid& grid, Motion motion) {
  const std::string shape = deck::word(deck, of, "shape");
  if (shape.empty()) return std::nullopt;
  const bool timed = motion == Motion::in_time;
  Units units;
  // A contact in SI with an error in it has been complained about already.
  units.a.known = units.height.known = physics.language == Language::si || given(deck, "contact", "load");
  if (physics.si) {
    units.a.in_SI = physics.si->hertz.a;
    units.height.in_SI = physics.si->hertz.h_scale;
  }
  if (motion != Motion::dry) check_at_rest(deck, of, physics, timed);
  std::optional<CarriedSurface> surface;
  if (shape == "map")
    surface = map_of(deck, of, units, grid, timed);
  else
    surface = CarriedSurface{of, shape, feature_of(deck, of, units, grid, timed), std::nullopt};
  if (!timed && surface && deck.errors.empty()) check_influence(deck, *surface, grid);
  return surface;
}

}  // namespace

SurfaceInput surface_input(deck::Deck& deck, const Physics& physics, const core::Grid& grid, Motion motion) {
  SurfaceInput surfaces{carried_by(deck, "surface1", physics, grid, motion),
                        carried_by(deck, "surface2", physics, grid, motion)};
  if (given(deck, "surface1", "at_rest") && given(deck, "surface2", "at_rest"))
    complain(deck, "surface2", "at_rest", "of both surfaces: nothing would carry the oil into the contact");
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
  // Scenes are copied, maps need not be.
  const auto shared = std::make_shared<const std::vector<surface::Relief>>(std::move(all));
  scene.surface = [shared](const core::Patch& grid, core::Field& S) {
    S.fill(0.0);
    for (const surface::Relief& relief : *shared) surface::add_cell_average(relief, grid, S);
  };
}

}  // namespace ehl::program
