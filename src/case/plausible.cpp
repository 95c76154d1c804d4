#include "case/plausible.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/text_format.hpp"
#include "effects/roller/slices.hpp"

namespace ehl::program {
namespace {

constexpr double thickest_oil = 100.0;     // Pa s; ten times that of honey
constexpr double fastest_surface = 200.0;  // m/s; reached in turbine bearings
constexpr double surface_at_rest = 2.0;    // slide-roll ratio; above it one surface moves backwards
constexpr double edge_that_cuts = 0.8;     // share of the mean load per length [bench: roller_edge_that_cuts]
constexpr double coarse_course = 0.02;     // deviation over the range of what varies
constexpr double thinnest_film = 1e-9;     // m; about one molecule of oil
constexpr double thickest_film = 10e-6;    // m

}  // namespace

core::Warnings hardly_meant(const Case& input) {
  core::Warnings warnings;
  const Physics& physics = input.physics;
  if (std::abs(physics.srr) > surface_at_rest)
    warnings.push_back(
        {"backwards", fmt::format("srr = {:.4g} is outside -2 to 2: surface {} moves against the rolling direction",
                                  physics.srr, physics.srr > 0.0 ? 2 : 1)});
  if (const double at_ends = input.roller ? roller::bearing(*input.roller).at_ends : 0.0; at_ends > edge_that_cuts)
    warnings.push_back(
        {"roller-edge", fmt::format("edge loading: a slice model gives {:.2g} of the mean load per length at the ends "
                                    "of the roller, which few meshes resolve; let the profile fall further there",
                                    at_ends)});
  const machines::Number* error = nullptr;
  if (input.machine && deck::word(input.deck, "transient", "cycle") == "machine")
    error = machines::find_number(*input.machine, machines::error_of_course);
  if (error != nullptr && error->value > coarse_course)
    warnings.push_back({"coarse-course",
                        fmt::format("between the states of [{}] the course deviates by up to {:.2g} % of the range of "
                                    "radius or speed: use more states",
                                    input.machine->section, 100.0 * error->value)});
  if (!physics.si) return warnings;
  const double eta0 = physics.si->contact.eta0;
  if (eta0 > thickest_oil)
    warnings.push_back(
        {"thick-oil", fmt::format("eta0 = {:.4g} Pa s is above {:g} Pa s, thicker than an oil: is it in mPa s?", eta0,
                                  thickest_oil)});
  for (const double u : {physics.si->u1, physics.si->u2})
    if (std::abs(u) > fastest_surface) {
      const std::string slip = input.machine
                                   ? "check the units of the lengths and speeds in [" + input.machine->section + "]"
                                   : "is it in mm/s?";
      warnings.push_back(
          {"fast", fmt::format("a surface moves with {:.4g} m/s, above {:g} m/s: {}", u, fastest_surface, slip)});
      break;
    }
  return warnings;
}

core::Warnings hardly_a_film(double h_c, double h_m) {
  const double least = std::fmin(h_c, h_m);  // the smaller of the known values
  // Without a film, the report says elsewhere that the mesh does not resolve it.
  if (least <= 0.0) return {};
  if (least < thinnest_film)
    return {{"thin-film", "the film is " + length(least) +
                              " at its minimum, thinner than a molecule of oil: mixed lubrication is likely, which is "
                              "computed with [mixed] only"}};
  if (h_c > thickest_film)
    return {{"thick-film",
             "the film is " + length(h_c) + " at the centre, above 10 um: check the units of speed and viscosity"}};
  return {};
}

}  // namespace ehl::program
