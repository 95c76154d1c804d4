#include "tables/sweep_row.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "report/quantities.hpp"
#include "steady/solve.hpp"

namespace ehl::program {
namespace {

// Those that the row has a column for.
void take(const std::vector<Quantity>& quantities, SweepRow& row) {
  for (const Quantity& one : quantities)
    if (const auto column = std::ranges::find(row, one.name, &Quantity::name); column != row.end())
      column->value = one.value;
}

void take_case(const Case& input, SweepRow& row) {
  take(scale_quantities(input.physics), row);
  in_row(row, "nx") = input.scene.grid.nx;
  in_row(row, "ny") = input.scene.grid.ny;
}

SweepRow solve_case(const std::string& path, const std::string& deck_text, const std::vector<std::string>& overrides,
                    SweepRow row) {
  std::optional<Case> input;
  try {
    if (deck::load_text(path) != deck_text)
      throw core::InputError(path + ": the deck has changed since the sweep began");
    input = read_lubricated_case(path, overrides, 1, "sweep");
    return row_of_solution(*input, steady::solve(input->scene), row);
  } catch (const core::InputError& error) {
    if (input) take_case(*input, row);
    return row_without_solution(row, "refused", wrong_input, deck::joined(error.messages(), "; "));
  } catch (const core::SolverError& error) {
    take_case(*input, row);
    return row_without_solution(row, "not-converged", not_converged, error.what());
  }
}

}  // namespace

SweepRow sweep_row(bool with_friction) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  SweepRow row{{"status", "failed"},
               {"exit_status", 0},
               {"method", "none"},
               {"attempts", 0},
               {"M", unknown},
               {"L", unknown},
               {"p_h", unknown, "Pa"},
               {"nx", 0},
               {"ny", 0},
               {"Hc", unknown},
               {"Hm", unknown},
               {"P_max", unknown},
               {"error_Hc", unknown},
               {"error_Hm", unknown},
               {"residual", unknown},
               {"load_error", unknown},
               {"cycle_factor", unknown},
               {"cycles", 0},
               {"work_units", unknown},
               {"seconds", unknown, "s"},
               {"peak_memory", unknown, "bytes"},
               {"path", "none"}};
  if (with_friction)
    for (const char* name : {"mu", "mu_rolling", "mu_1", "mu_2"}) row.push_back({name, unknown});
  row.push_back({"warnings", 0});
  row.push_back({"reason", ""});
  return row;
}

results::Value& in_row(SweepRow& row, const std::string& name) {
  return std::ranges::find(row, name, &Quantity::name)->value;
}

SweepRow row_without_solution(SweepRow row, const std::string& status, int exit_status, const std::string& reason) {
  in_row(row, "status") = status;
  in_row(row, "exit_status") = exit_status;
  in_row(row, "reason") = reason;
  return row;
}

SweepRow row_of_solution(const Case& input, const steady::Solution& solution, SweepRow row) {
  take_case(input, row);
  if (solution.levels.empty() || solution.H.nodes_x() == 0)
    return row_without_solution(row, "not-converged", not_converged, solution.failed_check);
  const Outcome outcome = outcome_of(input, solution);
  const bool finite = std::isfinite(outcome.Hc + outcome.Hm.value + outcome.P_max.value);
  take(quantities_of(level_columns(), solution.levels.back()), row);
  take(film_quantities(input, solution, outcome), row);
  in_row(row, "path") = path_code(solution);
  in_row(row, "attempts") = static_cast<int>(solution.attempts.size());
  auto warnings = outcome.warnings.size();
  if (solution.converged && finite) {
    in_row(row, "status") = "converged";
    if (input.friction) {
      const friction::Friction found = friction_of(input, solution);
      take(friction_quantities(found), row);
      warnings += friction::warnings(found).size();
    }
  } else {
    row = row_without_solution(row, "not-converged", not_converged,
                               finite ? solution.failed_check : "the film or the pressure is not finite");
    for (const char* name : {"Hc", "Hm", "P_max", "error_Hc", "error_Hm"})
      in_row(row, name) = std::numeric_limits<double>::quiet_NaN();
  }
  in_row(row, "warnings") = static_cast<int>(warnings);
  return row;
}

SweepRow sweep_case(const std::string& path, const std::string& deck_text, const std::vector<std::string>& overrides,
                    bool with_friction) {
  const double began = core::now();
  SweepRow row = solve_case(path, deck_text, overrides, sweep_row(with_friction));
  in_row(row, "seconds") = std::stod(fmt::format("{:.4g}", core::now() - began));
  in_row(row, "peak_memory") = peak_memory();
  return row;
}

bool names_friction(const std::string& path, const std::vector<std::string>& overrides) {
  return deck::given(deck::read(path, overrides, catalogue()), "friction", "cavitated");
}

}  // namespace ehl::program
