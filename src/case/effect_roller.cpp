// The effect `roller`: rollers of finite length.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "case/roller_input.hpp"
#include "case/roller_report.hpp"
#include "core/constants.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"
#include "effects/roller/keys.hpp"
#include "effects/roller/scene.hpp"
#include "steady/multigrid_solve.hpp"
#include "steady/solve.hpp"

namespace ehl::program {
namespace {

// The filters and the roughness of a traced profile.
std::string trace_text(const Case& input) {
  const roller::Profile& profile = *input.roller;
  const roller::Trace& trace = profile.trace;
  if (profile.shape != roller::Profile::Shape::table) return {};
  const auto height = [&](double H) {
    return input.physics.si ? length(H * input.physics.si->hertz.h_scale) : fmt::format("{:.4g} a^2/R", H);
  };
  std::string text = ", Rq " + height(trace.rough) + " without the form";
  if (trace.shortest_wave > 0.0)
    text += fmt::format(" ({} before waves below {:.4g} half widths were removed)", height(trace.rough_before),
                        trace.shortest_wave);
  if (trace.level) text += fmt::format(", levelled by dH/dY = {:.4g}", trace.slope);
  return text;
}

std::string what(const Case& input) {
  const roller::Profile& profile = *input.roller;
  const std::string tilt = profile.tilt != 0.0 ? fmt::format(", tilt dH/dY = {:.4g}", profile.tilt) : "";
  return fmt::format("{:.4g} half widths long, profile {}, {:.4g} a^2/R below the middle at the ends{}{}",
                     profile.length, deck::word(input.deck, "roller", "profile"),
                     roller::drop(profile, 0.5 * profile.length), tilt, trace_text(input));
}

std::string asymmetry(const Case& input) {
  if (input.roller->tilt != 0.0) return "the roller is tilted";
  return roller::symmetric(*input.roller) ? "" : "the profile table is not symmetric";
}

// The cost of the grid of half as many cells; that of the dry contact is small.
Needs expense(const Case& input) { return {.seconds = basic_needs(input.scene).seconds}; }

constexpr int fewest_cells = 64;  // of the coarser grid, so that the multigrid method can start on it

// in: traced: the profile was measured; its roughness may prevent a solution on the coarser grid.
std::optional<steady::Solution> on_coarser_grid(steady::Scene scene, bool traced, RunSettings& settings) {
  if (scene.grid.nx < 2 * fewest_cells || scene.grid.nx % 2 != 0 || scene.grid.ny % 4 != 0) return std::nullopt;
  scene.grid = core::coarsened(scene.grid);
  scene.deformation = mlmi::fitting(scene.deformation, scene.grid);
  scene.adjoint_errors = scene.error_maps = false;
  if (scene.solver.coarsest_cells > scene.grid.nx) scene.solver.coarsest_cells = 0;
  if (traced) scene.one_start_only = "an error bar is worth one start";
  try {
    steady::Solution solution = steady::solve(scene, [&](const steady::Progress& now) {
      return settings.progress.show(now.fraction, "roller on half as many cells");
    });
    return solution.converged ? std::optional(std::move(solution)) : std::nullopt;
  } catch (const core::SolverError&) {
    return std::nullopt;
  }
}

roller::Distribution dry_distribution(const steady::Scene& scene, bool solved) {
  const core::Patch grid = steady::on_one_half(scene) ? core::lower_half(scene.grid) : core::Patch(scene.grid);
  dry::Problem problem = roller::dry_problem(scene, grid);
  problem.parameters.tolerance = solved ? 1e-6 : 1e-3;  // without a film to compare with, it is coarser
  const dry::Solution dry = dry::solve(problem);
  return roller::distribution(dry.grid, dry.P, dry.H);
}

/// Largest von Mises stress at the nodes of the middle half of the length, and near the ends.
struct Stresses {
  double middle = core::unknown, end = core::unknown;
};
Stresses stresses_of(const subsurface::StressField& field) {
  const auto mises = std::ranges::find(field.kept, subsurface::sigma_mises, &subsurface::Volume::quantity);
  if (mises == field.kept.end()) return {};
  Stresses found{0.0, 0.0};
  for (const core::Field& plane : mises->planes)
    for (int i = 0; i <= field.grid.nx; ++i)
      for (int j = 0; j <= field.grid.ny; ++j) {
        const double Y = field.grid.Y(j);
        if (roller::near_end(field.grid, Y)) found.end = std::max(found.end, plane(i, j));
        if (std::abs(Y) <= 0.5 * field.grid.Y_b) found.middle = std::max(found.middle, plane(i, j));
      }
  return found;
}

Stresses coarser_stresses(const Case& input, const steady::Solution& coarser, const subsurface::StressField& finer) {
  subsurface::Parameters parameters = *input.subsurface;
  parameters.friction = finer.parameters.friction;
  parameters.most_cells = finer.grid.nx / 2;
  parameters.kept = {subsurface::sigma_mises};
  return stresses_of(subsurface::stress_below(coarser.grid, coarser.P, parameters, input.scene.threads));
}

void compute(const Case& input, RunSettings& settings, Computed& computed) {
  const double began = core::now();
  RollerResult result{.found = roller::distribution(computed.solution.grid, computed.solution.P, computed.solution.H)};
  result.pressures_settle = computed.solution.error_bars.P_max_converging;
  steady::Scene scene = input.scene;  // with the grid that was found for the accuracy
  scene.grid = computed.solution.grid;
  scene.accuracy = {};
  // A contact that touches is given up: its dry contact would take as long as the film.
  if (!computed.solution.converged && !scene.one_start_only.empty())
    result.dry.middle.P_max = result.dry.lower.P = result.dry.upper.P = core::unknown;
  else
    result.dry = dry_distribution(scene, computed.solution.converged);
  // Without a solution of the contact, a coarser grid has nothing to compare with.
  std::optional<steady::Solution> coarser;
  result.solved = computed.solution.converged;
  if (result.solved) coarser = on_coarser_grid(scene, input.roller->trace.rough > 0.0, settings);
  if (coarser) result.coarser = roller::distribution(coarser->grid, coarser->P, coarser->H);
  Stresses finer, coarse;
  if (computed.stresses) {
    finer = stresses_of(*computed.stresses);
    if (coarser) coarse = coarser_stresses(input, *coarser, *computed.stresses);
  }
  result.mises_middle = finer.middle;
  result.mises_end = finer.end;
  result.mises_middle_coarser = coarse.middle;
  result.mises_end_coarser = coarse.end;
  result.seconds = core::now() - began;
  computed.roller = std::move(result);
}

Json json(const Case& input, const Computed& computed) {
  Json report;
  const std::vector<results::Quantity> list = numbers::quantities("roller", {input, computed});
  add(list, report);
  add_in_SI(list, si_scales(input.physics), report);
  report["seconds"] = computed.roller->seconds;
  return report;
}

void add_content(const Case& input, const Computed& computed, results::Content& content) {
  numbers::append("roller", {input, computed}, content.summary);
  content.tables.push_back(
      table_of("roller", "values along the roller, with oil", slice_columns(), computed.roller->found.slices));
  content.tables.push_back(
      table_of("roller_dry", "values along the roller, without oil", slice_columns(), computed.roller->dry.slices));
}

}  // namespace

Effect roller_effect() {
  return {.name = "roller",
          .meaning = "A roller of finite length: its profile along the axis, and its tilt.",
          .stage = Stage::coefficients,
          .sections = {{.name = "roller", .called_by = {"profile"}}},
          .keys = roller::keys,
          .read = roller_input,
          .on = [](const Case& input) { return input.roller.has_value(); },
          .what = what,
          .expense = expense,
          .asymmetry = asymmetry,
          .compute = compute,
          .summary = roller_summary,
          .json = json,
          .warnings = [](const Case&, const Computed& computed) { return roller_warnings(*computed.roller); },
          .add_content = add_content,
          .seconds = [](const Computed& computed) { return computed.roller->seconds; },
          .example = {"contact.kind=roller", "contact.length=20", "roller.profile=logarithmic", "-domain.y_half"}};
}

}  // namespace ehl::program
