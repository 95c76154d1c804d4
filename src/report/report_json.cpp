#include "core/processor_level.hpp"
#include "report/fluid_report.hpp"
#include "report/json.hpp"
#include "report/report.hpp"

namespace ehl::program {
namespace {

using Members = std::vector<std::pair<std::string, std::string>>;
using json::number;
using json::text;

std::string levels_json(const steady::Solution& solution) {
  std::vector<std::string> rows;
  for (const steady::LevelRow& row : solution.levels)
    rows.push_back(json::object({{"level", number(row.level)},
                                 {"nx", number(row.nx)},
                                 {"ny", number(row.ny)},
                                 {"Hc", number(row.Hc)},
                                 {"Hm", number(row.Hm)},
                                 {"error_Hc", number(row.error_Hc)},
                                 {"error_Hm", number(row.error_Hm)},
                                 {"Hm_fitted", number(row.Hm_fitted)},
                                 {"P_max", number(row.P_max)},
                                 {"residual", number(row.residual)},
                                 {"load_error", number(row.load_error)},
                                 {"cycles", number(row.cycles)},
                                 {"work_units", number(row.work_units)},
                                 {"seconds", number(row.seconds)}}));
  return json::array(rows);
}

std::string formulas_json(const std::vector<Formula>& formulas) {
  std::vector<std::string> rows;
  for (const Formula& formula : formulas)
    rows.push_back(
        json::object({{"name", text(formula.name)}, {"Hc", number(formula.Hc)}, {"Hm", number(formula.Hm)}}));
  return json::array(rows);
}

std::string verification_json(const steady::Verification& checked) {
  return json::object({{"residual", number(checked.residual)},
                       {"largest_residual", number(checked.largest_residual)},
                       {"largest_residual_X", number(checked.largest_residual_X)},
                       {"largest_residual_Y", number(checked.largest_residual_Y)},
                       {"least_P", number(checked.least_P)},
                       {"dry_violation", number(checked.dry_violation)},
                       {"load_error", number(checked.load_error)},
                       {"change_Hc", number(checked.change_Hc)},
                       {"change_Hm", number(checked.change_Hm)},
                       {"algebraic_error_Hc", number(checked.algebraic_error_Hc)},
                       {"algebraic_error_Hm", number(checked.algebraic_error_Hm)},
                       {"Hm", number(checked.Hm)},
                       {"Hm_X", number(checked.Hm_X)},
                       {"Hm_Y", number(checked.Hm_Y)},
                       {"flow_through", number(checked.flow_through)},
                       {"flow_imbalance", number(checked.flow_imbalance)},
                       {"flow_imbalance_whole", number(checked.flow_imbalance_whole)}});
}

std::string bar_json(const steady::ErrorBar& bar) {
  return json::object({{"discretization", number(bar.discretization)},
                       {"algebraic", number(bar.algebraic)},
                       {"total", number(bar.total())}});
}

std::string error_parts_json(const steady::ErrorBars& bars) {
  return json::object({{"Hc", bar_json(bars.Hc)},
                       {"Hm", bar_json(bars.Hm)},
                       {"Hm_fitted", bar_json(bars.Hm_fitted)},
                       {"domain", number(bars.domain)}});
}

std::string accuracy_json(const steady::AccuracyReport& accuracy) {
  if (!(accuracy.asked > 0.0)) return "null";
  return json::object({{"asked", number(accuracy.asked)},
                       {"met", json::boolean(accuracy.met)},
                       {"by_extrapolation", json::boolean(accuracy.by_extrapolation)},
                       {"stopped_by", text(accuracy.stopped_by)}});
}

std::string attempts_json(const steady::Solution& solution) {
  std::vector<std::string> rows;
  for (const steady::Attempt& attempt : solution.attempts)
    rows.push_back(json::object(
        {{"method", text(attempt.method)}, {"reason", text(attempt.reason)}, {"seconds", number(attempt.seconds)}}));
  return json::array(rows);
}

std::string continuation_json(const steady::Solution& solution) {
  std::vector<std::string> rows;
  for (const steady::ContinuationStep& step : solution.continuation)
    rows.push_back(json::object({{"M", number(step.M)},
                                 {"load_ratio", number(step.load_ratio)},
                                 {"converged", json::boolean(step.converged)},
                                 {"cycles", number(step.cycles)},
                                 {"Hc", number(step.Hc)},
                                 {"Hm", number(step.Hm)},
                                 {"residual", number(step.residual)}}));
  return json::array(rows);
}

std::string newton_json(const steady::Solution& solution) {
  std::vector<std::string> rows;
  for (const newton::Step& step : solution.newton)
    rows.push_back(
        json::object({{"residual", number(step.residual)}, {"linear_iterations", number(step.linear_iterations)}}));
  return json::array(rows);
}

std::string parts_json(const core::PartTimes& times) {
  std::vector<std::string> rows;
  for (std::size_t k = 0; k < times.seconds.size(); ++k)
    rows.push_back(
        json::object({{"name", text(core::name(static_cast<core::Part>(k)))}, {"seconds", number(times.seconds[k])}}));
  return json::array(rows);
}

std::string texts_json(const std::vector<std::string>& list) {
  std::vector<std::string> rows;
  for (const std::string& entry : list) rows.push_back(text(entry));
  return json::array(rows);
}

}  // namespace

std::string json_report(const Case& input, const steady::Solution& solution, const Outcome& outcome, double peak_memory,
                        const Members& effects) {
  const contact::Groups& groups = input.physics.groups;
  const steady::LevelRow last = solution.levels.empty() ? steady::LevelRow{} : solution.levels.back();
  const steady::ErrorBars& bars = solution.error_bars;
  const FilmCoefficients coefficients = film_coefficients(input.physics);
  Members members{{"converged", json::boolean(solution.converged)},
                  {"failed_check", text(solution.failed_check)},
                  {"title", text(input.title)},
                  {"Hc", number(outcome.Hc)},
                  {"Hm", number(outcome.Hm.value)},
                  {"error_Hc", number(bars.Hc.total())},
                  {"error_Hm", number(bars.Hm.total())},
                  {"Hc_extrapolated", number(bars.Hc_extrapolated.value)},
                  {"error_Hc_extrapolated", number(bars.Hc_extrapolated.error)},
                  {"Hm_extrapolated", number(bars.Hm_extrapolated.value)},
                  {"error_Hm_extrapolated", number(bars.Hm_extrapolated.error)},
                  {"Hm_fitted", number(bars.Hm_fitted_value)},
                  {"Hm_fitted_X", number(bars.Hm_fitted_X)},
                  {"Hm_fitted_Y", number(bars.Hm_fitted_Y)},
                  {"P_max_converging", json::boolean(bars.P_max_converging)},
                  {"error_P_max", number(bars.P_max)},
                  {"error_parts", error_parts_json(bars)},
                  {"accuracy", accuracy_json(solution.accuracy)},
                  {"Hc_moes", number(outcome.Hc_moes)},
                  {"Hm_moes", number(outcome.Hm_moes)},
                  {"hc_m", number(outcome.hc)},
                  {"hm_m", number(outcome.hm)},
                  {"P_max", number(outcome.P_max.value)},
                  {"H00", number(solution.H00)},
                  {"residual", number(last.residual)},
                  {"load_error", number(last.load_error)},
                  {"M", number(groups.M)},
                  {"L", number(groups.L)},
                  {"alpha_bar", number(groups.alpha_bar)},
                  {"lambda", number(groups.lambda)},
                  {"alpha_star", number(coefficients.alpha_star)},
                  {"alpha_film", number(coefficients.alpha_film)},
                  {"wedge", text(name(input.scene.wedge))},
                  {"deformation", text(name(input.scene.deformation.method))},
                  {"seconds", number(solution.seconds)},
                  {"threads", number(input.scene.threads)},
                  {"cpu_level", text(core::processor_level())},
                  {"peak_memory_bytes", number(peak_memory)},
                  {"levels", levels_json(solution)},
                  {"verification", verification_json(solution.verification)},
                  {"method", text(solution.method)},
                  {"cycle_factor", number(solution.cycle_factor)},
                  {"attempts", attempts_json(solution)},
                  {"continuation", continuation_json(solution)},
                  {"newton", newton_json(solution)},
                  {"parts", parts_json(solution.times)},
                  {"formulas", formulas_json(outcome.formulas)},
                  {"regime", text(outcome.regime)},
                  {"warnings", texts_json(outcome.warnings)}};
  if (!contact::circular(groups.shape)) {
    members.emplace_back("radius_ratio", number(groups.shape.radius_ratio));
    members.emplace_back("angle", number(groups.shape.angle));
    members.emplace_back("kappa", number(groups.shape.kappa));
  }
  members.insert(members.end(), effects.begin(), effects.end());
  return json::object(members) + "\n";
}

std::string json_failure(const Case& input, const std::string& reason) {
  return json::object({{"converged", json::boolean(false)},
                       {"failed_check", text(reason)},
                       {"title", text(input.title)},
                       {"Hc", "null"},
                       {"Hm", "null"},
                       {"M", number(input.physics.groups.M)},
                       {"L", number(input.physics.groups.L)},
                       {"levels", "[]"},
                       {"warnings", "[]"}}) +
         "\n";
}

}  // namespace ehl::program
