// The dry contact: from the case to the printed report and the result file.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "base/machine.hpp"
#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "contact/yield.hpp"
#include "core/constants.hpp"
#include "core/norms.hpp"
#include "core/processor_level.hpp"
#include "report/contact_lines.hpp"
#include "report/outcome.hpp"
#include "report/result_content.hpp"
#include "run/solver.hpp"
#include "steady/multigrid_solve.hpp"

namespace ehl::program {
namespace {

// Estimates the share of the work that is done: on each grid the error falls at a constant rate, and the next grid
// costs four times as much.
double fraction(const dry::Progress& now, double tolerance) {
  const double of_grid = std::clamp(std::log(now.error) / std::log(tolerance), 0.0, 1.0);
  return std::pow(4.0, -now.grids_left) * (0.25 + 0.75 * of_grid);
}

void solve(const Case& input, Progress& progress, Computed& computed) {
  const core::Patch grid =
      input.scene.use_symmetry ? core::lower_half(input.scene.grid) : core::Patch(input.scene.grid);
  dry::Problem problem = dry::ball_on_flat(grid, input.scene.surface);
  problem.deformation = input.scene.deformation;
  problem.parameters = input.dry->parameters;
  problem.threads = input.scene.threads;
  problem.kernel = steady::geometry_of(input.scene).kernel;
  dry::Solution& solution = computed.dry.emplace();
  solution = dry::solve(problem, [&](const dry::Progress& now) {
    return progress.show(fraction(now, problem.parameters.tolerance),
                         fmt::format("{} x {}  iteration {}  gap error {:.1e}", now.grid.nodes_x(), now.grid.nodes_y(),
                                     now.iteration, now.error));
  });
  const core::Location highest = core::maximum(solution.P);
  Outcome& outcome = computed.outcome;
  outcome.P_max = {highest.value, solution.grid.X(highest.i), solution.grid.Y(highest.j)};
  if (std::optional<core::Warning> beyond = contact::beyond_yield(input.physics.p_h))
    outcome.warnings.push_back(*beyond);
  for (core::Warning& warning : surface_warnings(input.surfaces, input.scene.grid))
    outcome.warnings.push_back(std::move(warning));
  computed.solution.grid = solution.grid;
  computed.solution.P = solution.P;
  computed.solution.H00 = solution.H00;
  computed.solution.deformation = solution.deformation;
  computed.solution.seconds = solution.seconds;
  computed.solution.converged = solution.converged;
  computed.solution.failed_check = solution.failed_check;
}

std::string contact_lines(const ElasticContact& contact) {
  return fmt::format("contact      F = {:.6g} N, R = {}, E' = {}\n", contact.bodies.load, length(contact.bodies.radius),
                     pressure_in_GPa(contact.bodies.E_prime)) +
         "Hertz        a = " + length(contact.hertz.a) + ", p_h = " + pressure_in_GPa(contact.hertz.p_h) +
         ", a^2/R = " + length(contact.hertz.h_scale) + "\n";
}

std::string table(const dry::Solution& solution, const std::optional<SiScales>& si) {
  std::string text = fmt::format("       nodes  {}{:>8}  approach  {:>8}  {}  iterations  {:>8}\n",
                                 si ? numbers::heading_in_si(id::p_max) + "  approach [nm]  " : "", id::P_max, id::area,
                                 id::gap_error, id::seconds);
  for (const dry::GridRow& row : solution.rows)
    text +=
        fmt::format("{:>12}  {}{:8.5f}  {:8.5f}  {:8.5f}  {:9.0e}  {:10}  {:8.3f}\n",
                    fmt::format("{} x {}", row.nx + 1, row.ny + 1),
                    si ? fmt::format("{:11.5f}  {:13.2f}  ", 1e-9 * si->p_h * row.P_max, -1e9 * si->h * row.H00) : "",
                    row.P_max, -row.H00, row.area, row.error, row.iterations, row.seconds);
  return text;
}

// The number in SI, followed by the dimensionless number.
std::string both(const std::string& in_SI, const std::string& own) { return in_SI.empty() ? own : in_SI + "; " + own; }

std::string summary(const Case& input, const Computed& computed) {
  const dry::Solution& solution = *computed.dry;
  const Place& P_max = computed.outcome.P_max;
  const std::optional<ElasticContact>& contact = input.dry->contact;
  const std::optional<SiScales> si = si_scales(input.physics);
  const char* mark = convergence_mark(solution.converged);
  const dry::GridRow& last = solution.rows.back();
  std::string text = table(solution, si);
  if (!solution.converged) text += "NOT CONVERGED: " + solution.failed_check + "\n";
  text += fmt::format("{:<13}", numbers::symbol_of(id::p_max)) +
          both(si ? pressure_in_GPa(P_max.value * si->p_h) + ", at " + place_text(P_max.X, P_max.Y, *si) : "",
               fmt::format("P = {:.5f}, at ({:.3f}, {:.3f}) a{}\n", P_max.value, P_max.X, P_max.Y, mark));
  text += "approach     " + both(si ? length(-solution.H00 * si->h) : "",
                                 fmt::format("{:.5f} a^2/R (smooth: 1){}\n", -solution.H00, mark));
  text += "area         " +
          both(si ? fmt::format("{:.5g} um^2", 1e12 * si->a * si->a * last.area) : "",
               fmt::format("{:.5f} a^2, {:.4f} of the Hertz circle{}\n", last.area, last.area / core::pi, mark));
  if (contact) text += contact_lines(*contact);
  text += fmt::format("load         error {:.1e}; gap in contact and overlap outside at most {:.1e} a^2/R\n",
                      solution.load_error, last.error);
  text += "method       dry, conjugate gradients; deformation " + solution.deformation + "; " +
          threads_text(input.scene.threads) + "\n";
  text += fmt::format("time         {:.3f} s\n", solution.seconds);
  return text + warning_lines(computed.outcome.warnings);
}

std::vector<results::Quantity> quantities(const Case& input, const Computed& computed) {
  std::vector<results::Quantity> list;
  for (const char* group : {"film", "course"}) numbers::append(group, {input, computed}, list);
  return list;
}

std::vector<Column<dry::GridRow>> grid_columns() {
  using Row = dry::GridRow;
  using numbers::column;
  return {column<Row>(id::nx, &Row::nx),
          column<Row>(id::ny, &Row::ny),
          column<Row>(id::P_max, &Row::P_max),
          column<Row>(id::H00, &Row::H00),
          column<Row>(id::area, &Row::area),
          column<Row>(id::gap_error, &Row::error),
          {"iterations", "-", "number of conjugate gradient iterations", &Row::iterations},
          {id::seconds, "s", "time on the grid", &Row::seconds}};
}

std::string json(const Case& input, const Computed& computed) {
  Json report;
  add(quantities(input, computed), report);
  report["kind"] = "dry";
  add(numbers::scale_quantities(input), report);
  report[id::deformation] = name(input.scene.deformation.method);
  report["threads"] = input.scene.threads;
  report["cpu_level"] = core::processor_level();
  report["peak_memory_bytes"] = peak_memory();
  report["grids"] = rows_json(grid_columns(), computed.dry->rows);
  add_warnings(computed.outcome.warnings, report);
  add_effects(input, computed, report);
  return line_of(report);
}

results::Content content(const Case& input, const Computed& computed) {
  const dry::Solution& solution = *computed.dry;
  results::Content content = content_of(input, computed, quantities(input, computed));
  content.scales = numbers::scale_quantities(input);
  content.fields = {{"P", "p_h", "pressure p/p_h", &solution.P}, {"gap", "a^2/R", "gap h R/a^2", &solution.H}};
  if (input.scene.surface)
    content.fields.push_back(
        {"S", "a^2/R", "height that the surfaces add to the gap, averaged over cells", &computed.derived.S});
  content.tables = {table_of("grids", "the grids, coarse to fine", grid_columns(), solution.rows)};
  return content;
}

std::string derived_dry(const Case& input) {
  const core::Grid& grid = input.scene.grid;
  const Needs needs = expected_needs(input);
  return "case         " + input.title + "\n" +
         (input.dry->contact ? contact_lines(*input.dry->contact)
                             : "contact      in units of Hertz: P in p_h, x in a\n") +
         domain_lines(grid, si_scales(input.physics)) + "method       dry, conjugate gradients; deformation " +
         name(input.scene.deformation.method) +
         fmt::format("\nkind         dry: no lubricant; conjugate gradients to {:.1g} a^2/R\n",
                     input.dry->parameters.tolerance) +
         effect_lines(input) + surface_report(input.surfaces, input.physics, grid) + "needs        about " +
         memory(needs.bytes) + " and " + about_seconds(needs.seconds) + "\n";
}

}  // namespace

Solver dry_solver() {
  return {.solve = solve, .derived = derived_dry, .summary = summary, .json = json, .content = content};
}

}  // namespace ehl::program
