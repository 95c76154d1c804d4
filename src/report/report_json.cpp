#include <optional>

#include "base/json.hpp"
#include "base/machine.hpp"
#include "case/effects.hpp"
#include "case/numbers/number.hpp"
#include "core/processor_level.hpp"
#include "report/contact_lines.hpp"
#include "report/course_columns.hpp"
#include "report/report.hpp"

namespace ehl::program {
namespace {

// Films are in SI if the contact is. deviation = (formula - computed film)/(computed film).
std::vector<Column<Formula>> formula_columns(const Case& input, const Outcome& outcome) {
  std::vector<Column<Formula>> columns{{"name", "", "", &Formula::name},
                                       {id::Hc, "a^2/R", "central film", &Formula::Hc},
                                       {id::Hm, "a^2/R", "minimum film", &Formula::Hm}};
  const std::optional<SiScales> si = si_scales(input.physics);
  if (!si) return columns;
  const auto add_film = [&](const std::string& name, double Formula::*film, double computed) {
    columns.push_back(
        {"h" + name + "_m", "m", "the same value in metres", [=](const Formula& f) { return si->h * f.*film; }});
    columns.push_back({"deviation_h" + name, "-", "", [=](const Formula& f) { return deviation(f.*film, computed); }});
  };
  add_film("c", &Formula::Hc, outcome.Hc);
  add_film("m", &Formula::Hm, outcome.Hm.value);
  return columns;
}

std::vector<Column<steady::Attempt>> attempt_columns() {
  using Row = steady::Attempt;
  return {{id::method, "", "strategy", &Row::method},
          {id::reason, "", "why it found no solution", &Row::reason},
          {id::seconds, "s", "time of the attempt", &Row::seconds}};
}

std::vector<Column<newton::Step>> newton_columns() {
  using Row = newton::Step;
  return {{id::residual, "-", "relative residual after the step", &Row::residual},
          {"linear_iterations", "-", "iterations of the linear solver", &Row::linear_iterations}};
}

Json parts_of(const steady::ErrorBar& bar) {
  return {{"discretization", bar.discretization}, {"algebraic", bar.algebraic}, {"total", bar.total()}};
}

Json accuracy_json(const steady::AccuracyReport& accuracy) {
  if (!(accuracy.asked > 0.0)) return nullptr;
  return {{"asked", accuracy.asked},
          {"met", accuracy.met},
          {"by_extrapolation", accuracy.by_extrapolation},
          {"stopped_by", accuracy.stopped_by}};
}

Json parts_json(const core::PartTimes& times) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < times.seconds.size(); ++k)
    rows.push_back({{"name", core::name(static_cast<core::Part>(k))}, {id::seconds, times.seconds[k]}});
  return rows;
}

}  // namespace

std::string json_report(const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  const Outcome& outcome = computed.outcome;
  const FilmCoefficients coefficients = film_coefficients(input.physics);
  Json report;
  const numbers::Solved solved{input, computed};
  add(numbers::quantities("film", solved), report);
  add(numbers::quantities("course", solved), report);
  if (solution.starvation)
    for (const char* one : {id::starvation_factor, id::mass_imbalance}) add({numbers::quantity(one, solved)}, report);
  add(numbers::quantities("roughness", solved), report);
  report["error_parts"][id::Hc] = parts_of(solution.error_bars.Hc);
  report["error_parts"][id::Hm] = parts_of(solution.error_bars.Hm);
  report["error_parts"][id::Hm_fitted] = parts_of(solution.error_bars.Hm_fitted);
  add(numbers::scale_quantities(input), report);
  report["alpha_star"] = coefficients.alpha_star;
  report["alpha_film"] = coefficients.alpha_film;
  report["wedge"] = name(input.scene.wedge);
  report["face"] = name(input.scene.face);
  report[id::deformation] = name(input.scene.deformation.method);
  report["threads"] = input.scene.threads;
  report["cpu_level"] = core::processor_level();
  report["peak_memory_bytes"] = peak_memory();
  report["accuracy"] = accuracy_json(solution.accuracy);
  report["levels"] = rows_json(level_columns(), solution.levels);
  add(numbers::quantities("verification", solved), report["verification"]);
  report["attempts"] = rows_json(attempt_columns(), solution.attempts);
  report["continuation"] = rows_json(continuation_columns(), solution.continuation);
  report["newton"] = rows_json(newton_columns(), solution.newton);
  report["parts"] = parts_json(solution.times);
  report["formulas"] = rows_json(formula_columns(input, outcome), outcome.formulas);
  if (coated(input.physics)) report["formulas_note"] = formulas_if_coated;
  add_warnings(outcome.warnings, report);
  add_effects(input, computed, report);
  return line_of(report);
}

std::string json_failure(const Case& input, const std::string& reason) {
  return line_of({{id::converged, false},
                  {id::failed_check, reason},
                  {id::title, input.title},
                  {id::Hc, nullptr},
                  {id::Hm, nullptr},
                  {id::M, input.physics.groups.M},
                  {id::L, input.physics.groups.L},
                  {"levels", Json::array()},
                  {id::warnings, Json::array()},
                  {"warning_names", Json::array()}});
}

}  // namespace ehl::program
