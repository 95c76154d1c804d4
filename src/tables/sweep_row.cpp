#include "tables/sweep_row.hpp"

#include <cmath>
#include <optional>

#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "commands/exit_status.hpp"
#include "commands/machine.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "report/outcome.hpp"
#include "report/text_format.hpp"
#include "steady/solve.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

struct Column {
  std::string name;
  std::string text;
};

std::vector<Column> columns_of(const SweepRow& row) {
  std::vector<Column> columns{{"status", row.status},
                              {"exit_status", std::to_string(row.exit_status)},
                              {"method", row.method.empty() ? "none" : csv_word(row.method)},
                              {"attempts", std::to_string(row.attempts)},
                              {"M", csv_number(row.M)},
                              {"L", csv_number(row.L)},
                              {"p_h", csv_number(row.p_h)},
                              {"nx", std::to_string(row.nx)},
                              {"ny", std::to_string(row.ny)},
                              {"Hc", csv_number(row.Hc)},
                              {"Hm", csv_number(row.Hm)},
                              {"P_max", csv_number(row.P_max)},
                              {"error_Hc", csv_number(row.error_Hc)},
                              {"error_Hm", csv_number(row.error_Hm)},
                              {"residual", csv_number(row.residual)},
                              {"load_error", csv_number(row.load_error)},
                              {"cycle_factor", csv_number(row.cycle_factor)},
                              {"cycles", std::to_string(row.cycles)},
                              {"work_units", csv_number(row.work_units)},
                              {"seconds", std::isfinite(row.seconds) ? formatted("%.4g", row.seconds) : "NaN"},
                              {"peak_memory", csv_number(row.peak_memory)}};
  if (row.with_friction)
    for (const auto& [name, value] :
         {std::pair{"mu", row.mu}, {"mu_rolling", row.mu_rolling}, {"mu_1", row.mu_1}, {"mu_2", row.mu_2}})
      columns.push_back({name, csv_number(value)});
  columns.push_back({"warnings", std::to_string(row.warnings)});
  columns.push_back({"reason", csv_quoted(row.reason)});
  return columns;
}

SweepRow row_of_case(const Case& input) {
  SweepRow row;
  row.M = input.physics.groups.M;
  row.L = input.physics.groups.L;
  row.p_h = input.physics.si ? input.physics.si->hertz.p_h : input.physics.p_h;
  row.nx = input.scene.grid.nx;
  row.ny = input.scene.grid.ny;
  return row;
}

SweepRow not_converged_row(const Case& input, const std::string& reason) {
  SweepRow row = row_of_case(input);
  row.status = "not-converged";
  row.exit_status = not_converged;
  row.reason = reason;
  return row;
}

SweepRow solve_case(const std::string& path, const std::string& deck_text, const std::vector<std::string>& overrides) {
  std::optional<Case> input;
  try {
    if (deck::load_text(path) != deck_text)
      throw core::InputError(path + ": the deck has changed since the sweep began");
    input = read_lubricated_case(path, overrides, 1, "sweep");
    return row_of_solution(*input, steady::solve(input->scene));
  } catch (const core::InputError& error) {
    SweepRow row = input ? row_of_case(*input) : SweepRow{};
    row.status = "refused";
    row.exit_status = wrong_input;
    row.reason = deck::joined(error.messages(), "; ");
    return row;
  } catch (const core::SolverError& error) {
    return not_converged_row(*input, error.what());
  }
}

// With its warnings among the others.
void take_friction(const friction::Friction& found, SweepRow& row) {
  row.mu = found.sliding;
  row.mu_rolling = found.rolling;
  row.mu_1 = found.on_1;
  row.mu_2 = found.on_2;
  row.warnings += static_cast<int>(friction::warnings(found).size());
}

}  // namespace

std::string sweep_columns(bool with_friction) {
  std::vector<std::string> names;
  for (const Column& column : columns_of({.with_friction = with_friction})) names.push_back(column.name);
  return deck::joined(names, ",");
}

std::string sweep_text(const SweepRow& row) {
  std::vector<std::string> texts;
  for (const Column& column : columns_of(row)) texts.push_back(column.text);
  return deck::joined(texts, ",");
}

SweepRow row_of_solution(const Case& input, const steady::Solution& solution) {
  if (solution.levels.empty() || solution.H.nodes_x() == 0) return not_converged_row(input, solution.failed_check);
  const steady::LevelRow& finest = solution.levels.back();
  const Outcome outcome = outcome_of(input, solution);
  const bool finite = std::isfinite(outcome.Hc + outcome.Hm.value + outcome.P_max.value);
  const bool converged = solution.converged && finite;
  SweepRow row =
      converged ? row_of_case(input)
                : not_converged_row(input, finite ? solution.failed_check : "the film or the pressure is not finite");
  if (converged) {
    row.status = "converged";
    row.exit_status = solved;
    row.Hc = outcome.Hc;
    row.Hm = outcome.Hm.value;
    row.P_max = outcome.P_max.value;
    row.error_Hc = finest.error_Hc;
    row.error_Hm = finest.error_Hm;
  }
  row.method = solution.method;
  row.attempts = static_cast<int>(solution.attempts.size());
  row.nx = finest.nx;
  row.ny = finest.ny;
  row.residual = finest.residual;
  row.load_error = finest.load_error;
  row.cycle_factor = solution.cycle_factor;
  row.cycles = finest.cycles;
  row.work_units = finest.work_units;
  row.warnings = static_cast<int>(outcome.warnings.size());
  if (converged && input.friction) take_friction(friction_of(input, solution), row);
  return row;
}

SweepRow sweep_case(const std::string& path, const std::string& deck_text, const std::vector<std::string>& overrides) {
  const double began = core::now();
  SweepRow row = solve_case(path, deck_text, overrides);
  row.seconds = core::now() - began;
  row.peak_memory = peak_memory();
  return row;
}

bool names_friction(const std::string& path, const std::vector<std::string>& overrides) {
  return deck::given(deck::read(path, overrides, catalogue()), "friction", "cavitated");
}

SweepRow row_of_failure(int exit_status, const std::string& reason) {
  SweepRow row;
  row.status = "failed";
  row.exit_status = exit_status;
  row.reason = reason;
  return row;
}

}  // namespace ehl::program
