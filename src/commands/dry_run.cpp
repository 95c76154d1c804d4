#include "commands/dry_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "case/effects.hpp"
#include "commands/commands.hpp"
#include "commands/exit_status.hpp"
#include "commands/machine.hpp"
#include "commands/signals.hpp"
#include "contact/yield.hpp"
#include "core/constants.hpp"
#include "core/norms.hpp"
#include "core/processor_level.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"
#include "deck/write.hpp"
#include "report/json.hpp"
#include "report/outcome.hpp"
#include "report/result_content.hpp"
#include "report/text_format.hpp"
#include "results/write.hpp"

namespace ehl::program {
namespace {

constexpr double hertz_load = 2.0 * core::pi / 3.0;  // of P = sqrt(1 - r^2)

struct DryResult {
  dry::Solution solution;
  Computed computed;  ///< what the effects see of it, and what they add
  Place P_max;
  std::vector<std::string> warnings;
  core::Field S;  ///< what the surfaces add to the gap; empty where they are smooth
};

bool show(const dry::Progress& now, bool quiet, double& last_time) {
  if (stop_requested()) return false;
  constexpr double interval = 5.0;  // s
  const double time = core::now();
  if (quiet || time - last_time < interval) return true;
  last_time = time;
  std::fprintf(stderr, "ehl: %d x %d  iteration %d  gap wrong by %.1e; %d finer grids to come\n", now.grid.nodes_x(),
               now.grid.nodes_y(), now.iteration, now.error, now.grids_left);
  return true;
}

DryResult solved_contact(const Case& input, bool quiet) {
  const core::Grid grid = input.scene.use_symmetry ? core::lower_half(input.scene.grid) : input.scene.grid;
  dry::Problem problem{
      grid, dry::smooth_gap(grid), hertz_load, input.scene.deformation, input.dry->parameters, input.scene.threads};
  if (input.scene.surface) {
    core::Field S(grid);
    input.scene.surface(grid, S);
    for (int i = 0; i < grid.nodes_x(); ++i)
      for (int j = 0; j < grid.nodes_y(); ++j) problem.gap(i, j) += S(i, j);
  }
  const double began = core::now();
  double last_time = began;
  DryResult result;
  result.solution = dry::solve(problem, [&](const dry::Progress& now) { return show(now, quiet, last_time); });
  const core::Location highest = core::maximum(result.solution.P);
  result.P_max = {highest.value, result.solution.grid.X(highest.i), result.solution.grid.Y(highest.j)};
  if (std::optional<std::string> beyond = contact::beyond_yield(input.physics.p_h)) result.warnings.push_back(*beyond);
  for (std::string& warning : surface_warnings(input.surfaces, input.scene.grid))
    result.warnings.push_back(std::move(warning));
  if (input.scene.surface) {
    result.S = core::Field(result.solution.grid);
    input.scene.surface(result.solution.grid, result.S);
  }
  steady::Solution& seen = result.computed.solution;
  seen.grid = result.solution.grid;
  seen.P = result.solution.P;
  seen.converged = result.solution.converged;
  RunSettings settings{.quiet = quiet};
  for (const Effect& effect : effects_of(input))
    if (effect.compute) effect.compute(input, settings, result.computed);
  result.computed.seconds = core::now() - began;
  return result;
}

std::string contact_lines(const ElasticContact& contact) {
  return fmt::format("contact      F = {:.6g} N, R = {}, E' = {}\n", contact.load, length(contact.radius),
                     pressure(contact.E_prime)) +
         "Hertz        a = " + length(contact.hertz.a) + ", p_h = " + pressure(contact.hertz.p_h) +
         ", a^2/R = " + length(contact.hertz.h_scale) + "\n";
}

std::string table(const dry::Solution& solution) {
  std::string text = "       nodes     P_max  approach      area  gap error  iterations   seconds\n";
  for (const dry::GridRow& row : solution.rows)
    text += fmt::format("{:>12}  {:8.5f}  {:8.5f}  {:8.5f}  {:9.0e}  {:10}  {:8.3f}\n",
                        fmt::format("{} x {}", row.nx + 1, row.ny + 1), row.P_max, -row.H00, row.area, row.error,
                        row.iterations, row.seconds);
  return text;
}

std::string summary(const Case& input, const DryResult& result) {
  const dry::Solution& solution = result.solution;
  const std::optional<ElasticContact>& contact = input.dry->contact;
  const std::string mark = solution.converged ? "" : "  (NOT CONVERGED)";
  const double p_h = input.physics.p_h;
  const dry::GridRow& last = solution.rows.back();
  std::string text = "case         " + input.title + "\n" + table(solution);
  if (!solution.converged) text += "NOT CONVERGED: " + solution.failed_check + "\n";
  text += fmt::format("p_max        P = {:.5f}{}, at ({:.3f}, {:.3f}) a{}\n", result.P_max.value,
                      contact ? (", " + pressure(result.P_max.value * p_h)) : "", result.P_max.X, result.P_max.Y, mark);
  text += fmt::format("approach     {:.5f} a^2/R{} (smooth: 1){}\n", -solution.H00,
                      contact ? (", " + length(-solution.H00 * contact->hertz.h_scale)) : "", mark);
  text += fmt::format("area         {:.5f} a^2, {:.4f} of Hertz' circle{}\n", last.area, last.area / core::pi, mark);
  if (contact) text += contact_lines(*contact);
  text += fmt::format("load         error {:.1e}; gap in contact and overlap outside at most {:.1e} a^2/R\n",
                      solution.load_error, last.error);
  text += "method       dry, conjugate gradients; deformation " + solution.deformation +
          fmt::format("; {}\n", threads_text(input.scene.threads));
  text += fmt::format("time         {:.3f} s\n", solution.seconds);
  text += warning_lines(result.warnings);
  for (const Effect& effect : effects_of(input))
    if (effect.summary) text += effect.summary(input, result.computed);
  return text + effect_times(input, result.computed) + "memory       " +
         std::to_string(static_cast<long>(peak_memory() / 1e6)) + " MB at most\n";
}

std::vector<results::Quantity> quantities(const DryResult& result) {
  const dry::Solution& solution = result.solution;
  return {{"converged", solution.converged, "-", "1: all checks passed, 0: not"},
          {"failed_check", solution.failed_check, "", "empty when converged"},
          {"P_max", result.P_max.value, "p_h", "highest pressure of all nodes"},
          {"P_max_x", result.P_max.X, "a", "where it is", "P_max_X"},
          {"P_max_y", result.P_max.Y, "a", "where it is", "P_max_Y"},
          {"H00", solution.H00, "a^2/R", "minus the mutual approach"},
          {"area", solution.rows.back().area, "a^2", "area of the nodes in contact"},
          {"gap_error", solution.rows.back().error, "a^2/R", "largest gap in the contact, overlap outside"},
          {"load_error", solution.load_error, "-", "relative error of the load"},
          {"seconds", solution.seconds, "s", "time of the solution"},
          {"deformation", solution.deformation, "", "how the elastic deformation was evaluated", results::not_in_json}};
}

std::vector<Column<dry::GridRow>> grid_columns() {
  using Row = dry::GridRow;
  return {{"nx", "-", "cells along x", &Row::nx},
          {"ny", "-", "cells along y", &Row::ny},
          {"P_max", "p_h", "highest pressure of all nodes", &Row::P_max},
          {"H00", "a^2/R", "minus the mutual approach", &Row::H00},
          {"area", "a^2", "area of the nodes in contact", &Row::area},
          {"gap_error", "a^2/R", "largest gap in the contact, largest overlap outside", &Row::error},
          {"iterations", "-", "conjugate gradients", &Row::iterations},
          {"seconds", "s", "time on the grid", &Row::seconds}};
}

std::string report(const Case& input, const DryResult& result) {
  Json json;
  add(quantities(result), json);
  json["title"] = input.title;
  json["kind"] = "dry";
  json["p_h_Pa"] = input.physics.p_h;
  json["deformation"] = name(input.scene.deformation.method);
  json["threads"] = input.scene.threads;
  json["cpu_level"] = core::processor_level();
  json["peak_memory_bytes"] = peak_memory();
  json["grids"] = rows_json(grid_columns(), result.solution.rows);
  json["warnings"] = result.warnings;
  add_effects(input, result.computed, json);
  return line_of(json);
}

results::Content content_of(const Case& input, const DryResult& result) {
  const dry::Solution& solution = result.solution;
  results::Content content;
  content.title = input.title;
  content.deck = deck::effective_deck(input.deck);
  content.provenance = provenance(input);
  if (const std::optional<ElasticContact>& contact = input.dry->contact)
    content.scales = {{"p_h", contact->hertz.p_h, "Pa", "Hertz pressure, the scale of P"},
                      {"a", contact->hertz.a, "m", "Hertz radius, the scale of X and Y"},
                      {"h", contact->hertz.h_scale, "m", "a^2/R, the scale of the gap"},
                      {"load", contact->load, "N", "normal load"},
                      {"R", contact->radius, "m", "reduced radius"},
                      {"E_prime", contact->E_prime, "Pa", "reduced modulus"}};
  content.grid = solution.grid;
  content.fields = {{"P", "p_h", "pressure p/p_h", &solution.P}, {"gap", "a^2/R", "gap h R/a^2", &solution.H}};
  if (input.scene.surface)
    content.fields.push_back({"S", "a^2/R", "what the surfaces add to the gap, as means over cells", &result.S});
  content.summary = quantities(result);
  content.summary.push_back({"warnings", deck::joined(result.warnings, "\n"), "", "one a line"});
  add_surface_records(input, solution.grid, content);
  content.tables = {table_of("grids", "the grids, coarse to fine", grid_columns(), solution.rows)};
  for (const Effect& effect : effects_of(input))
    if (effect.add_content) effect.add_content(input, result.computed, content);
  content.effects = effect_rows(input, result.computed);
  return content;
}

}  // namespace

int run_dry(const Arguments& arguments, const Case& input, const std::string& path, bool overwrite) {
  const DryResult result = solved_contact(input, arguments.has("quiet"));
  print(arguments.has("json") ? report(input, result) : summary(input, result));
  results::write(path, content_of(input, result), overwrite);
  if (!arguments.has("json")) print("result       " + path + "\n");
  if (result.solution.converged) return solved;
  std::fprintf(stderr, "ehl: not converged: %s\n", result.solution.failed_check.c_str());
  return not_converged;
}

std::string derived_dry(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  std::string text = "case         " + input.title + "\n";
  text +=
      input.dry->contact ? contact_lines(*input.dry->contact) : "contact      in units of Hertz: P in p_h, x in a\n";
  text += fmt::format("domain       [{:g}, {:g}] x [{:g}, {:g}] Hertz radii\n", grid.X_a, grid.X_b, grid.Y_a, grid.Y_b);
  text += fmt::format("grid         {} x {} nodes, hx = {:.4g}, hy = {:.4g}\n", grid.nodes_x(), grid.nodes_y(),
                      grid.hx(), grid.hy());
  text += std::string("method       dry, conjugate gradients; deformation ") + name(input.scene.deformation.method) +
          "\nkind         dry: no lubricant; conjugate gradients to " +
          fmt::format("{:.1g} a^2/R\n", input.dry->parameters.tolerance);
  for (const Effect& effect : effects_of(input))
    text += "effects      " + effect.name + ": " + effect.what(input) + "\n";
  text += surface_report(input.surfaces, input.physics, grid);
  const Needs needs = expected_needs(input);
  text += "needs        about " + memory(needs.bytes) + " and " + about_seconds(needs.seconds) + "\n";
  return text;
}

}  // namespace ehl::program
