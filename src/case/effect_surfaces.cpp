// The effect `surfaces`: features, waviness and measured heights on the surfaces.
#include <fmt/core.h>

#include <numbers>

#include "base/json.hpp"
#include "case/effects.hpp"
#include "case/surface_input.hpp"
#include "core/constants.hpp"
#include "deck/text.hpp"
#include "surface/keys.hpp"

namespace ehl::program {
namespace {

// The height of the feature (for a map its rms) relative to the expected film of smooth surfaces. A height that is not
// flattened elastically penetrates the film.
std::string over_film(const CarriedSurface& surface, const steady::Scene& scene) {
  const auto* feature = std::get_if<surface::Feature>(&surface.relief);
  const double height = feature ? feature->height : surface.map->rms;
  return fmt::format(", {} {:.2g} of the smooth film", feature ? "height" : "rms", height / scene.contact.film);
}

std::string what(const Case& input) {
  std::vector<std::string> shapes;
  for (const CarriedSurface* one : carried(input.surfaces)) {
    std::string text = one->shape + " on " + one->section;
    if (input.transient) {
      const Travel travel = travel_of(*one, *input.transient);
      text += fmt::format(" (x = {:.4g} to {:.4g} a)", travel.from, travel.to);
    } else if (!input.dry) {
      text += ", at rest";
    }
    if (!input.dry) text += over_film(*one, input.scene);
    shapes.push_back(text);
  }
  return deck::joined(shapes, ", ");
}

// Why a surface is not symmetric: "ridge of surface1 at 30 degrees".
std::string asymmetry_of(const CarriedSurface& one) {
  const auto* feature = std::get_if<surface::Feature>(&one.relief);
  const std::string name = one.shape + " of " + one.section;
  if (!feature) return name;
  return name + (feature->Y != 0.0 ? fmt::format(" at y = {:.4g}", feature->Y)
                                   : fmt::format(" at {:.4g} degrees", feature->angle * 180.0 / std::numbers::pi));
}

std::string asymmetry(const Case& input) {
  std::vector<std::string> reasons;
  for (const CarriedSurface* one : carried(input.surfaces))
    if (!surface::symmetric(one->relief)) reasons.push_back(asymmetry_of(*one));
  return deck::joined(reasons, ", ");
}

// The cost: evaluating the shape in every step; if the shape is not symmetric in Y, also the other half of the domain.
Needs expense(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  const double nodes = static_cast<double>(grid.nodes_x()) * grid.nodes_y();
  constexpr double share_of_a_step = 0.05;  // share of the time of a step
  constexpr double fields_at_rest = 2.0;    // the right-hand side of the film equation, and S for the result
  if (!input.transient)
    return {.bytes = nodes * sizeof(double) * fields_at_rest,
            .seconds = asymmetry(input).empty() ? 0.0 : basic_needs(input.scene).seconds};
  const Needs one_half = expense_in_time(input);
  Needs more{.bytes = nodes * sizeof(double), .seconds = share_of_a_step * one_half.seconds};
  if (asymmetry(input).empty()) return more;
  more.bytes += nodes * sizeof(double) * doubles_of_history;
  more.seconds = 2.0 * more.seconds + one_half.seconds;
  return more;
}

// The processing of each measured map, by the name of its section.
void json(const Case& input, const Computed&, Json& report) {
  for (const CarriedSurface* one : carried(input.surfaces)) {
    if (!one->map) continue;
    const MapRecord& record = *one->map;
    report[one->section] = {{"file", record.file},
                            {"missing_points", record.filled},
                            {"levelling", record.plane_taken ? "plane" : "mean"},
                            {"mean_taken_away", record.plane.mean},
                            {"slope_x_taken_away", record.plane.slope_x},
                            {"slope_y_taken_away", record.plane.slope_y},
                            {"Sq_levelled", record.rms_levelled},
                            {"Sq", record.rms},
                            {"Sa", record.mean}};
  }
}

}  // namespace

Effect surfaces_effect() {
  return {
      .name = "surfaces",
      .meaning = "Shapes on a surface that move through the contact in time, or stand still in a steady contact.",
      .without = "smooth",
      .sections =
          {{.name = "surface1",
            .meaning = "Shape on surface 1. It moves through the contact in time, or stands still in a steady contact.",
            .called_by = {"shape"}},
           {.name = "surface2", .meaning = "Shape on surface 2, as for [surface1].", .called_by = {"shape"}}},
      .keys = surface::keys,
      .stages = {.scene =
                     [](Case& input) {
                       if (!input.transient) let_stand(input.surfaces, input.scene);
                     }},
      .on = [](const Case& input) { return !carried(input.surfaces).empty(); },
      .what = what,
      .expense = expense,
      .asymmetry = asymmetry,
      .summary =
          [](const Case& input, const Computed& computed) {
            return surface_report(input.surfaces, input.physics, computed.solution.grid);
          },
      .json = json,
      .seconds =
          [](const Computed& computed) {
            // At rest the surfaces are part of the steady contact and are evaluated once per level.
            return computed.in_time ? computed.in_time->report.seconds_of_surfaces : core::unknown;
          },
      .example = {"surface1.shape=dimple", "surface1.height=0.05", "surface1.width=0.5", "surface1.x=-0.5"},
      .upon = "transient"};
}

}  // namespace ehl::program
