#include "tables/sweep_row.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/effects.hpp"
#include "case/roller_report.hpp"
#include "case/thermal_report.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "report/contact_lines.hpp"
#include "report/outcome.hpp"
#include "run/pipeline.hpp"
#include "tables/kept_results.hpp"
#include "tables/sweep_table.hpp"
#include "tables/warning_names.hpp"

namespace ehl::program {
namespace {

using numbers::Known;

// Fills the cells that are known by then.
void fill(const SweepColumns& columns, Known by, const Case& input, const Computed& computed, SweepRow& row) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].value && columns[k].known <= by) row[k].value = columns[k].value({input, computed});
}

// What is known of a case without a solution.
void fill_case(const SweepColumns& columns, const Case& input, SweepRow& row) {
  Computed nothing{};
  nothing.outcome.formulas = film_formulas(input.physics);
  fill(columns, Known::before, input, nothing, row);
}

// in: now: the files as they are; before: the files as the sweep recorded them.
void check_unchanged(const std::vector<deck::NamedFile>& now, const std::vector<deck::NamedFile>& before) {
  for (const deck::NamedFile& file : now)
    if (std::ranges::find(before, deck::fingerprint(file), deck::fingerprint) == before.end())
      throw core::InputError(file.path + ": has changed since the sweep began");
}

SweepRow solved_row(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, std::string* kept) {
  std::optional<Case> input;
  const auto without_solution = [&](const std::string& status, int exit_status, const std::string& why) {
    SweepRow row = sweep_row(sweep.columns);
    if (input) fill_case(sweep.columns, *input, row);
    return row_without_solution(row, status, exit_status, why);
  };
  try {
    if (deck::load_text(sweep.deck) != sweep.deck_text)
      throw core::InputError(sweep.deck + ": the deck has changed since the sweep began");
    input = read_lubricated_case(sweep.deck, overrides, 1, "sweep");
    check_unchanged(input->files, sweep.files);
    input->scene.accuracy.most_nodes /= sweep.at_once;
    Progress progress([&](double, const std::string& text) {
      say(text);
      return true;
    });
    RunSettings settings{.progress = progress, .extent = Extent::row};
    if (kept == nullptr) settings.frame = [](transient::Frame&&) {};
    Computed computed;
    solve_case(*input, settings, computed);
    const SweepRow row = row_of_solution(sweep.columns, *input, computed);
    if (kept != nullptr && has_film(computed.solution)) {
      settings.extent = Extent::whole;
      if (computed.unsolved.empty()) compute_effects(*input, settings, computed);
      *kept = image_of(whole_content(*input, computed));
    }
    return row;
  } catch (const core::InputError& error) {
    return without_solution("refused", wrong_input, deck::joined(error.messages(), "; "));
  } catch (const core::SolverError& error) {
    return without_solution("not-converged", not_converged, error.what());
  }
}

}  // namespace

SweepRow sweep_row(const SweepColumns& columns) {
  SweepRow row;
  for (const numbers::SweepColumn& one : columns) row.push_back({one.name, one.blank, one.unit, one.meaning});
  return row;
}

std::vector<std::string> left_out(const deck::Deck& deck) {
  std::vector<std::string> lines;
  if (deck::called_for(deck, "transient"))
    lines.push_back(
        "[transient]: numbers without least, largest or mean in their names are those of the steady contact at time 0");
  if (deck::called_for(deck, "subsurface"))
    lines.push_back("[subsurface]: the table has no stresses; --keep keeps those of every case");
  if (deck::given(deck, "contact", "coating1_E") || deck::given(deck, "contact", "coating2_E"))
    lines.push_back(std::string("coatings: ") + formulas_if_coated);
  return lines;
}

results::Value& in_row(SweepRow& row, const std::string& name) {
  return std::ranges::find(row, name, &results::Quantity::name)->value;
}

SweepRow row_without_solution(SweepRow row, const std::string& status, int exit_status, const std::string& reason) {
  in_row(row, id::status) = status;
  in_row(row, id::exit_status) = exit_status;
  in_row(row, id::reason) = reason;
  return row;
}

SweepRow row_of_solution(const SweepColumns& columns, const Case& input, const Computed& computed) {
  const steady::Solution& solution = computed.solution;
  SweepRow row = sweep_row(columns);
  fill_case(columns, input, row);
  if (!has_film(solution)) return row_without_solution(row, "not-converged", not_converged, solution.failed_check);
  core::Warnings warnings = computed.outcome.warnings;
  const auto warn = [&](const core::Warnings& more) { warnings.insert(warnings.end(), more.begin(), more.end()); };
  const bool steady_converged = solution.converged && is_finite(computed.outcome);
  if (const std::string why = why_incomplete(computed.in_time); steady_converged && !why.empty()) {
    fill(columns, Known::solved, input, computed, row);
    row = row_without_solution(row, "not-converged", not_converged, why);
  } else if (steady_converged) {
    if (computed.in_time) {
      warnings = all_warnings(input, computed);
    } else {
      if (computed.friction) warn(friction::warnings(*computed.friction));
      if (computed.roller) warn(edge_warnings(computed.roller->found));
      if (computed.heat) warn(thermal_warnings(input, *computed.heat));
    }
    fill(columns, Known::converged, input, computed, row);
    in_row(row, id::status) = "converged";
  } else {
    fill(columns, Known::solved, input, computed, row);
    row = row_without_solution(
        row, "not-converged", not_converged,
        is_finite(computed.outcome) ? solution.failed_check : "the film or the pressure is not finite");
  }
  std::string words = names_of_warnings(warnings);
  if (std::fmax(results::number(in_row(row, id::error_Hc)), results::number(in_row(row, id::error_Hm))) >= 1.0)
    words = (words == "none" ? "" : words + " ") + hardly_an_error;
  in_row(row, id::warnings) = words;
  return row;
}

SweepRow sweep_case(const SweepHeader& sweep, const std::vector<std::string>& overrides,
                    const std::function<void(const std::string&)>& say, std::string* kept) {
  const double began = core::now();
  SweepRow row = solved_row(sweep, overrides, say, kept);
  if (!sweep.timing) return row;
  in_row(row, id::seconds) = std::stod(fmt::format("{:.4g}", core::now() - began));
  in_row(row, id::peak_memory) = peak_memory();
  return row;
}

}  // namespace ehl::program
