#include "tables/sweep_row.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "case/machine_input.hpp"
#include "case/roller_report.hpp"
#include "case/starvation_report.hpp"
#include "case/thermal_report.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "report/quantities.hpp"
#include "tables/kept_results.hpp"
#include "tables/si_columns.hpp"
#include "tables/sweep_table.hpp"
#include "tables/warning_names.hpp"

namespace ehl::program {
namespace {

// Copies the quantities for which the row has a column.
void take(const std::vector<Quantity>& quantities, SweepRow& row) {
  for (const Quantity& one : quantities)
    if (const auto column = std::ranges::find(row, one.name, &Quantity::name); column != row.end())
      column->value = one.value;
}

// in: si: the film, if there is one.
void take_si(const Case& input, SiRow si, SweepRow& row) {
  if (!input.physics.si) return;
  si.physics = input.physics;
  si.formulas = film_formulas(input.physics);
  const bool line = contact::line(input.physics.groups.shape);
  take(quantities_of(si_columns(line ? Bodies::line : Bodies::elliptic, true), si), row);
}

void take_film(const Case& input, const steady::Solution& solution, const Outcome& outcome, SweepRow& row) {
  const steady::ErrorBars& bars = solution.error_bars;
  take_si(input,
          {.roughness = outcome.roughness,
           .hc = outcome.hc,
           .hm = outcome.hm,
           .p_max = outcome.P_max.value * input.physics.p_h,
           .error_hc = bars.Hc.total(),
           .error_hm = bars.Hm.total()},
          row);
}

void take_case(const Case& input, SweepRow& row) {
  take(scale_quantities(input), row);
  take_si(input, {}, row);
  in_row(row, "nx") = input.scene.grid.nx;
  in_row(row, "ny") = input.scene.grid.ny;
}

// in: now: the files as they are; before: the files as the sweep recorded them.
void check_unchanged(const std::vector<deck::NamedFile>& now, const std::vector<deck::NamedFile>& before) {
  for (const deck::NamedFile& file : now)
    if (std::ranges::find(before, deck::told(file), deck::told) == before.end())
      throw core::InputError(file.path + ": has changed since the sweep began");
}

SweepRow solved_row(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, SweepRow row, std::string* kept) {
  std::optional<Case> input;
  try {
    if (deck::load_text(sweep.deck) != sweep.deck_text)
      throw core::InputError(sweep.deck + ": the deck has changed since the sweep began");
    input = read_lubricated_case(sweep.deck, overrides, 1, "sweep");
    check_unchanged(input->files, sweep.files);
    input->scene.accuracy.most_nodes /= sweep.at_once;
    const auto show = [&](const steady::Progress& now) {
      say(fmt::format("{} x {}, residual {:.1e}", now.nx + 1, now.ny + 1, now.residual));
      return true;
    };
    FilmSolution found = solve_film(*input, show);
    row = row_of_solution(*input, found, row);
    if (kept != nullptr && !found.film.levels.empty() && found.film.H.nodes_x() > 0)
      *kept = kept_result(*input, std::move(found));
    return row;
  } catch (const core::InputError& error) {
    if (input) take_case(*input, row);
    return row_without_solution(row, "refused", wrong_input, deck::joined(error.messages(), "; "));
  } catch (const core::SolverError& error) {
    take_case(*input, row);
    return row_without_solution(row, "not-converged", not_converged, error.what());
  }
}

}  // namespace

SweepRow sweep_row(const SweepKind& kind) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  SweepRow row{{"status", "failed"}, {"exit_status", 0}, {"method", "none"}, {"attempts", 0}};
  if (kind.si)
    for (const Column<SiRow>& column : si_columns(kind.bodies, kind.rough))
      row.push_back({column.name, unknown, column.unit});
  const SweepRow plain{{"M", unknown},
                       {"L", unknown},
                       {"p_h", unknown, "Pa"},
                       {"nx", 0},
                       {"ny", 0},
                       {"Hc", unknown},
                       {"Hm", unknown},
                       {"P_max", unknown},
                       {"error_Hc", unknown},
                       {"error_Hm", unknown},
                       {"Hc_best", unknown},
                       {"error_Hc_best", unknown},
                       {"Hm_best", unknown},
                       {"error_Hm_best", unknown},
                       {"residual", unknown},
                       {"load_error", unknown},
                       {"cycle_factor", unknown},
                       {"cycles", 0},
                       {"work_units", unknown},
                       {"path", "none"}};
  row.insert(row.end(), plain.begin(), plain.end());
  if (kind.timing) row.insert(row.end(), {{"seconds", unknown, "s"}, {"peak_memory", unknown, "bytes"}});
  if (kind.friction)
    for (const char* name : {"mu", "error_mu", "mu_rolling", "error_mu_rolling", "mu_1", "mu_2"})
      row.push_back({name, unknown});
  if (kind.thermal) {
    if (!kind.friction) row.insert(row.end(), {{"mu", unknown}, {"error_mu", unknown}});
    row.push_back({"mu_isothermal", unknown});
    for (const char* name : {"T_film_max", "T_film_mean", "T1_max", "T2_max"}) row.push_back({name, unknown, "K"});
    for (const char* name : {"heat_1", "heat_2"})
      row.push_back({name, unknown, unit_of_heat(kind.bodies == Bodies::line)});
    for (const char* name : {"heat_imbalance", "film_reduction", "nahme"}) row.push_back({name, unknown});
  }
  if (kind.starved)
    for (const char* name :
         {"starvation_factor", "supply_ratio", "Hc_flooded", "meniscus_x", "gamma", "mass_imbalance"})
      row.push_back({name, unknown});
  if (kind.roller) {
    row.insert(row.end(), {{"P_middle", unknown, "p_h"},
                           {"P_end", unknown, "p_h"},
                           {"H_end", unknown, "a^2/R"},
                           {"load_centre", unknown, "a"}});
    if (kind.si) row.push_back({"moment", unknown, "N m"});
  }
  for (const Quantity& one : kind.machine) row.push_back({one.name, unknown, one.unit});
  row.push_back({"warnings", "none"});
  row.push_back({"reason", ""});
  return row;
}

std::vector<std::string> left_out(const SweepKind& kind) {
  std::vector<std::string> lines;
  if (kind.in_time)
    lines.push_back("[transient]: no run in time is made; a row is the steady contact that `ehl run` would start from");
  if (kind.stress) lines.push_back("[subsurface]: the table has no stresses; --keep keeps those of every case");
  return lines;
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

SweepRow row_of_solution(const Case& input, const FilmSolution& found, SweepRow row) {
  const steady::Solution& solution = found.film;
  take_case(input, row);
  if (solution.levels.empty() || solution.H.nodes_x() == 0)
    return row_without_solution(row, "not-converged", not_converged, solution.failed_check);
  const Outcome outcome = outcome_of(input, solution);
  const bool finite = std::isfinite(outcome.Hc + outcome.Hm.value + outcome.P_max.value);
  take(quantities_of(level_columns(), solution.levels.back()), row);
  take(film_quantities(input, solution, outcome), row);
  in_row(row, "path") = path_code(solution);
  in_row(row, "attempts") = static_cast<int>(solution.attempts.size());
  core::Warnings warnings = outcome.warnings;
  const auto warn = [&](const core::Warnings& more) { warnings.insert(warnings.end(), more.begin(), more.end()); };
  if (solution.converged && finite) {
    in_row(row, "status") = "converged";
    take_film(input, solution, outcome, row);
    if (input.friction) {
      const friction::Friction rubbed = friction_of(input, solution, fields_of_film(found.heat, found.flow));
      take(friction_quantities(rubbed), row);
      warn(friction::warnings(rubbed));
    }
    if (solution.starvation) take(starvation_quantities(input, solution), row);
    if (input.roller) {
      const RollerResult carried{.found = roller::distribution(solution.grid, solution.P, solution.H)};
      take(roller_quantities(input, carried), row);
      warn(edge_warnings(carried.found));
    }
    if (found.heat) {
      take(thermal_quantities(input, *found.heat), row);
      warn(thermal_warnings(input, *found.heat));
    }
  } else {
    row = row_without_solution(row, "not-converged", not_converged,
                               finite ? solution.failed_check : "the film or the pressure is not finite");
    for (const char* name :
         {"Hc", "Hm", "P_max", "error_Hc", "error_Hm", "Hc_best", "error_Hc_best", "Hm_best", "error_Hm_best"})
      in_row(row, name) = std::numeric_limits<double>::quiet_NaN();
  }
  std::string names = names_of_warnings(warnings);
  if (std::fmax(results::number(in_row(row, "error_Hc")), results::number(in_row(row, "error_Hm"))) >= 1.0)
    names = (names == "none" ? "" : names + " ") + hardly_an_error;
  in_row(row, "warnings") = names;
  return row;
}

SweepRow sweep_case(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, std::string* kept) {
  const double began = core::now();
  SweepRow row = solved_row(sweep, overrides, say, sweep_row(sweep.kind), kept);
  if (!sweep.kind.timing) return row;
  in_row(row, "seconds") = std::stod(fmt::format("{:.4g}", core::now() - began));
  in_row(row, "peak_memory") = peak_memory();
  return row;
}

SweepKind kind_of_sweep(const std::string& path, const std::vector<std::string>& overrides) {
  deck::Deck deck = deck::read(path, overrides, catalogue());
  const std::optional<machines::Contact> machine = machine_input(deck);
  const auto names = [&](const char* section, const char* key) { return deck::given(deck, section, key); };
  const auto has_map = [&](const char* section) { return deck::word(deck, section, "shape") == "map"; };
  const std::string kind = deck::word(deck, "contact", "kind");
  return {.friction = names("friction", "cavitated"),
          .thermal = deck::called_for(deck, "thermal"),
          .starved = deck::called_for(deck, "supply"),
          .roller = deck::called_for(deck, "roller"),
          .in_time = deck::called_for(deck, "transient"),
          .stress = deck::called_for(deck, "subsurface"),
          .si = names("contact", "load") || names("contact", "load_per_length"),
          .bodies = kind == "line" || kind == "roller"                                 ? Bodies::line
                    : names("contact", "radius_y") || names("contact", "radius_ratio") ? Bodies::elliptic
                                                                                       : Bodies::circular,
          .rough = names("contact", "Sq1") || names("contact", "Sq2") || has_map("surface1") || has_map("surface2"),
          .machine = machine ? machine_quantities(*machine) : std::vector<Quantity>{}};
}

}  // namespace ehl::program
