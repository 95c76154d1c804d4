#include "tables/sweep_row.hpp"

#include <fmt/core.h>

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
#include "steady/solve.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

// Of the numbers of friction (case/effect_friction.cpp).
constexpr const char* friction_names[] = {"mu", "mu_rolling", "mu_1", "mu_2"};

std::vector<Column<SweepRow>> columns(bool with_friction) {
  using Row = SweepRow;
  std::vector<Column<Row>> list{{"status", "", "how it ended", &Row::status},
                                {"exit_status", "-", "of `ehl run`", &Row::exit_status},
                                {"method", "", "the way to the solution, in words", &Row::method},
                                {"attempts", "-", "ways that were tried", &Row::attempts},
                                {"M", "-", "Moes load number", &Row::M},
                                {"L", "-", "Moes material number", &Row::L},
                                {"p_h", "Pa", "Hertz pressure", &Row::p_h},
                                {"nx", "-", "cells along x", &Row::nx},
                                {"ny", "-", "cells along y", &Row::ny},
                                {"Hc", "-", "film at (0,0)", &Row::Hc},
                                {"Hm", "-", "smallest film of all nodes", &Row::Hm},
                                {"P_max", "-", "highest pressure of all nodes", &Row::P_max},
                                {"error_Hc", "-", "estimated relative discretization error", &Row::error_Hc},
                                {"error_Hm", "-", "estimated relative discretization error", &Row::error_Hm},
                                {"residual", "-", "relative residual of the Reynolds equation", &Row::residual},
                                {"load_error", "-", "relative error of the load", &Row::load_error},
                                {"cycle_factor", "-", "residual left by a cycle", &Row::cycle_factor},
                                {"cycles", "-", "on the finest grid", &Row::cycles},
                                {"work_units", "-", "on the finest grid", &Row::work_units},
                                {"seconds", "s", "the whole case, one thread", &Row::seconds},
                                {"peak_memory", "bytes", "of the process", &Row::peak_memory},
                                {"path", "", "the way to the solution, as a code", &Row::path}};
  for (std::size_t k = 0; with_friction && k < std::size(friction_names); ++k)
    list.push_back({friction_names[k], "-", "over the load", [k](auto& row) -> auto& { return row.friction[k];
}
}  // namespace
);
list.push_back({"warnings", "-", "how many", &Row::warnings});
list.push_back({"reason", "", "why there is no solution", &Row::reason});
return list;
}  // namespace ehl::program

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
  for (const results::Quantity& one : friction_quantities(found))
    for (std::size_t k = 0; k < std::size(friction_names); ++k)
      if (one.name == friction_names[k]) row.friction[k] = results::number(one.value);
  row.warnings += static_cast<int>(friction::warnings(found).size());
}

}  // namespace

std::string sweep_columns(bool with_friction) { return csv_names(columns(with_friction)); }

std::string sweep_units() { return csv_units(columns(false)); }

std::string sweep_text(const SweepRow& row) { return csv_row(columns(row.with_friction), row); }

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
  if (!solution.method.empty()) row.method = solution.method;
  row.path = path_code(solution);
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
  row.seconds = std::stod(fmt::format("{:.4g}", core::now() - began));
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
