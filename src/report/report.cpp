#include "report/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text_format.hpp"
#include "case/effects.hpp"
#include "case/needs.hpp"
#include "case/numbers/number.hpp"
#include "case/plausible.hpp"
#include "contact/film_formulas.hpp"
#include "core/constants.hpp"
#include "report/contact_lines.hpp"
#include "report/film_lines.hpp"
#include "report/moving_surfaces.hpp"
#include "report/roughness.hpp"

namespace ehl::program {
namespace {

std::string nodes(int nx, int ny) { return fmt::format("{} x {}", nx + 1, ny + 1); }

// The films of a row in SI, followed by the space between columns; empty without scales.
std::string columns_in_nm(double Hc, double Hm, const std::optional<SiScales>& si) {
  if (!si) return {};
  return fmt::format("{:>8}  {:>8}  ", known("{:.2f}", 1e9 * si->h * Hc), known("{:.2f}", 1e9 * si->h * Hm));
}

// Their headings.
std::string headings_in_nm(bool in_SI) {
  if (!in_SI) return {};
  return fmt::format("{:>8}  {:>8}  ", numbers::heading_in_si(id::hc), numbers::heading_in_si(id::hm));
}

}  // namespace

std::string level_table(const Case& input, const steady::Solution& solution) {
  const std::optional<SiScales> si = si_scales(input.physics);
  std::string text = fmt::format("level  {:>11}  {}{:>8}  {:>8}  {:>13}  {:>13}  {}  {}  {}  {:>8}\n", "nodes",
                                 headings_in_nm(si.has_value()), id::Hc, id::Hm, id::mesh_error_Hc, id::mesh_error_Hm,
                                 id::residual, id::load_error, id::work_units, id::seconds);
  const steady::ErrorBars& bars = solution.error_bars;
  for (const steady::LevelRow& row : solution.levels) {
    // The errors of the finest grid are those of its error bars; a coarser grid is judged by the grids below it alone.
    const bool judged = &row == &solution.levels.back() && std::isfinite(bars.Hc_best.value);
    text += fmt::format("{:5}  {:>11}  {}{:8.5f}  {:8.5f}  {:>13}  {:>13}  {:8.0e}  {:10.0e}  {:10.1f}  {:8.3f}\n",
                        row.level, nodes(row.nx, row.ny), columns_in_nm(row.Hc, row.Hm, si), row.Hc, row.Hm,
                        percent(judged ? bars.Hc.discretization : row.mesh_error_Hc),
                        percent(judged ? bars.Hm.discretization : row.mesh_error_Hm), row.residual, row.load_error,
                        row.work_units, row.seconds);
  }
  const bool has_order = !solution.levels.empty() && std::isfinite(solution.levels.back().order_Hc);
  if (has_order) text += fmt::format("observed order of {}: {:.2f}\n", id::Hc, solution.levels.back().order_Hc);
  return text;
}

std::string continuation_table(const Case& input, const steady::Solution& solution) {
  if (solution.continuation.empty()) return {};
  const std::optional<SiScales> si = si_scales(input.physics);
  std::string text =
      fmt::format("continuation{:>9}  {:>10}  {}{:>8}  {:>8}  {}  {}\n", id::M, si ? "load [N]" : "load ratio",
                  headings_in_nm(si.has_value()), id::Hc, id::Hm, id::residual, id::cycles);
  for (const steady::ContinuationStep& step : solution.continuation)
    text += fmt::format("{:21.6g}  {:10.4g}  {}{:>8}  {:>8}  {:>8}  {:6}{}\n", step.M,
                        si ? step.load_ratio * input.physics.si->contact.load : step.load_ratio,
                        columns_in_nm(step.Hc, step.Hm, si), known("{:.5f}", step.Hc), known("{:.5f}", step.Hm),
                        known("{:.0e}", step.residual), step.cycles,
                        step.converged ? "" : "  rejected: a shorter step follows");
  return text;
}

namespace {

// The strategy that led to the solution, and the strategies that failed before it.
std::string path(const steady::Solution& solution) {
  std::string text = "path         " + solution.method;
  if (std::isfinite(solution.cycle_factor)) text += fmt::format("; convergence factor {:.2f}", solution.cycle_factor);
  if (!solution.newton.empty())
    text += fmt::format("; {} Newton steps to {:.0e}", solution.newton.size(), solution.newton.back().residual);
  text += "\n";
  for (const steady::Attempt& attempt : solution.attempts)
    if (!attempt.reason.empty())
      text +=
          fmt::format("             tried before, {:.2f} s: {}: {}\n", attempt.seconds, attempt.method, attempt.reason);
  return text;
}

}  // namespace

std::string summary(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const Outcome& outcome = computed.outcome;
  const Physics& physics = input.physics;
  std::string text = continuation_table(input, solution) + level_table(input, solution);
  if (!solution.converged)
    text += (computed.in_time ? "NOT CONVERGED, the reference contact: " : "NOT CONVERGED: ") + solution.failed_check +
            "\n";
  // The films below belong to the steady start, so this message comes first.
  if (const std::string why = why_incomplete(computed.in_time); !why.empty())
    text += (computed.in_time->report.end == transient::MarchEnd::failed ? "NOT CONVERGED: " : "NOT COMPLETE: ") + why +
            "; the films here are those of its steady start\n";
  if (input.transient && input.transient->conditions.body && input.transient->conditions.body->gap)
    text +=
        "reference    the bodies start separated; this is the steady contact under the load of [contact]: it gives the "
        "scales and does not exist at time 0\n";
  text += film_lines(input, computed) + error_lines(input, solution);
  if (input.machine) text += machine_lines(*input.machine);
  if (physics.si) text += si_lines(*physics.si);
  text += group_lines(physics) + formula_lines(outcome.formulas, physics, outcome.Hc, outcome.Hm.value);
  text += roughness_line(input, outcome.roughness);
  text += path(solution);
  text += verified_lines(input, solution.verification);
  text += fmt::format("method       wedge {}, face {}; deformation {}; {}\ntime         {:.3f} s\n",
                      name(input.scene.wedge), name(input.scene.face), solution.deformation,
                      threads_text(input.scene.threads), solution.seconds);
  return text + warning_lines(outcome.warnings);
}

std::string profile_table(const core::PartTimes& times, double seconds) {
  std::string text = fmt::format("{:<29}  {:>8}  {:>5}\n", "profile", "seconds", "share");
  const auto row = [&](const char* part, double of_part) {
    text += fmt::format("  {:<27}  {:8.4f}  {:3.0f} %\n", part, of_part, 100.0 * of_part / seconds);
  };
  double rest = seconds;
  for (std::size_t k = 0; k < times.seconds.size(); ++k) {
    row(core::name(static_cast<core::Part>(k)), times.seconds[k]);
    rest -= times.seconds[k];
  }
  row("everything else", rest);
  return text;
}

core::Warnings foreseen_warnings(const Case& input) {
  core::Warnings warnings = hardly_meant(input);
  const std::vector<Formula> formulas = film_formulas(input.physics);
  if (const std::optional<SiInput>& si = input.physics.si; si && !formulas.empty())
    for (core::Warning& warning : hardly_a_film(formulas[0].Hc * si->hertz.h_scale, formulas[0].Hm * si->hertz.h_scale))
      warnings.push_back(std::move(warning));
  if (std::optional<core::Warning> warning = roughness_warning(input, roughness_of(input, formulas, std::nan(""))))
    warnings.push_back(*warning);
  for (core::Warning& warning : moving_surface_warnings(input)) warnings.push_back(std::move(warning));
  return warnings;
}

std::string derived(const Case& input) {
  const Physics& physics = input.physics;
  const steady::Scene& scene = input.scene;
  std::string text = "case         " + input.title + "\n";
  if (input.machine) text += machine_lines(*input.machine);
  if (physics.si) text += si_lines(*physics.si);
  text += group_lines(physics);
  const std::vector<Formula> formulas = film_formulas(physics);
  const std::optional<Roughness> roughness = roughness_of(input, formulas, std::nan(""));
  text += formula_lines(formulas, physics) + roughness_line(input, roughness);
  text += domain_lines(scene.grid, si_scales(physics));
  text += std::string("method       wedge ") + name(scene.wedge) + ", face " + name(scene.face) + "; deformation " +
          name(scene.deformation.method) + "\n";
  text += effect_lines(input) + surface_report(input.surfaces, physics, scene.grid);
  if (const core::Grid grid = predicted_grid(scene); !std::isnan(scene.accuracy.error))
    text += fmt::format("accuracy     {:g}: about {} nodes on [{:.4g}, {:.4g}] x [{:.4g}, {:.4g}]\n",
                        scene.accuracy.error, nodes(grid.nx, grid.ny), grid.X_a, grid.X_b, grid.Y_a, grid.Y_b);
  const Needs needs = expected_needs(input);
  return text + warning_lines(foreseen_warnings(input)) +
         fmt::format("needs        about {} and {} with {}{}\n", memory(needs.bytes), about_seconds(needs.seconds),
                     threads_text(scene.threads), what_needs_leave_out(input));
}

}  // namespace ehl::program
