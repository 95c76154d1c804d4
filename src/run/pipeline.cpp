#include "run/pipeline.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "base/text_format.hpp"
#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/text.hpp"
#include "report/outcome.hpp"
#include "report/report.hpp"
#include "report/result_content.hpp"
#include "results/write.hpp"
#include "run/error_bars_in_time.hpp"
#include "run/solver.hpp"

namespace ehl::program {

namespace {

Solver solver_of(const Case& input) { return input.dry ? dry_solver() : film_solver(); }

results::Content content_without_solution(const Case& input, const Computed& computed) {
  if (has_film(computed.solution) && is_finite(computed.outcome)) return solver_of(input).content(input, computed);
  results::Content content = content_of(
      input, computed, {numbers::given(id::converged, false), numbers::given(id::failed_check, computed.unsolved)});
  content.scales = numbers::scale_quantities(input);
  return content;
}

}  // namespace

void solve_case(const Case& input, RunSettings& settings, Computed& computed) try {
  const double began = core::now();
  solver_of(input).solve(input, settings.progress, computed);
  compute_effects(input, settings, computed);
  computed.seconds = core::now() - began;
} catch (const core::SolverError& error) {
  computed.unsolved = computed.solution.failed_check = error.what();
  computed.solution.converged = false;
  if (!has_film(computed.solution)) computed.solution.grid = input.scene.grid;
}

void compute_effects(const Case& input, RunSettings& settings, Computed& computed) {
  const Extent extent = settings.extent;
  if (extent == Extent::row && !computed.solution.converged) return;
  if (extent == Extent::whole) computed.derived = derived_fields(input, computed.solution);
  const std::vector<Effect> on = effects_of(input);
  // A sweep that keeps results comes here twice, and the run in time is there the second time.
  if (extent >= Extent::row && !computed.in_time) {
    for (const Effect& effect : on)
      if (effect.stages.in_time) effect.stages.in_time(input, settings, computed);
    add_error_bars_in_time(input, settings, computed);
  }
  for (const Effect& effect : on)
    if (effect.stages.after_solution && extent >= effect.stages.from)
      effect.stages.after_solution(input, settings, computed);
}

std::string solve_and_save(const Case& input, RunSettings settings, Computed& computed, bool is_continued,
                           const std::function<void(const results::Content& content)>& write) {
  bool has_part = is_continued;
  settings.save = [&](const std::function<void(results::Content & content)>& add) {
    results::Content content = solver_of(input).content(input, computed);
    add(content);
    write(content);
    has_part = true;
  };
  solve_case(input, settings, computed);
  // A run in time that fails has already saved more than this.
  if (!computed.unsolved.empty() && has_part) return "the run so far";
  const results::Content content = whole_content(input, computed);
  write(content);
  if (computed.unsolved.empty()) return "the result";
  return content.fields.empty() ? "the deck and this reason, but no film" : "the last film, marked as not converged";
}

results::Content whole_content(const Case& input, const Computed& computed) {
  if (!computed.unsolved.empty()) return content_without_solution(input, computed);
  results::Content content = solver_of(input).content(input, computed);
  add_effects(input, computed, content);
  return content;
}

std::string json_of(const Case& input, const Computed& computed) {
  return computed.unsolved.empty() ? solver_of(input).json(input, computed) : json_failure(input, computed.unsolved);
}

std::string derived_of(const Case& input) { return solver_of(input).derived(input); }

std::string printed(const Case& input, const Computed& computed, bool profile) {
  const std::string of_contact = solver_of(input).summary(input, computed);
  std::string of_effects;
  for (const Effect& effect : effects_of(input)) {
    if (effect.summary) of_effects += effect.summary(input, computed);
    if (effect.warnings) of_effects += warning_lines(effect.warnings(input, computed));
  }
  // If the bodies start separated, the steady contact is only the reference of the scales.
  const bool separated = input.transient && input.transient->conditions.body && input.transient->conditions.body->gap;
  std::string text = "case         " + input.title + "\n";
  text += separated ? of_effects + of_contact : of_contact + of_effects;
  text += effect_times(input, computed);
  if (const auto lines = solver_of(input).profile; profile && lines != nullptr) text += lines(input, computed);
  return text + "memory       " + std::to_string(static_cast<long>(peak_memory() / 1e6)) + " MB at most\n";
}

std::string unfit_as_result(const std::string& path) {
  if (results::xdmf_name(path) == path)
    return "the result cannot be named " + path + ": .xmf is the ending of its companion file; use .h5";
  if (!deck::is_utf8(path) || deck::has_control_character(path))
    return "the result cannot be named " + deck::quoted(path) +
           ": XDMF, which contains the name, needs UTF-8 without control characters";
  return {};
}

std::vector<std::string> files_of(const Case& input) {
  std::vector<std::string> paths;
  for (const deck::NamedFile& file : input.files) paths.push_back(file.path);
  return paths;
}

std::vector<results::Output> result_outputs(const std::string& path, bool overwrite, std::size_t bytes) {
  return {{path, results::FileKind::result, overwrite, bytes},
          {results::xdmf_name(path), results::FileKind::xdmf, overwrite}};
}

Ending ending_of(const Computed& computed, const std::string& to_go_on) {
  const std::optional<TransientResult>& in_time = computed.in_time;
  if (!computed.solution.converged && !in_time)
    return {computed.solution.accuracy.interrupted ? interrupted : not_converged,
            "not converged: " + computed.solution.failed_check};
  if (!in_time || completed(*in_time)) return {solved, {}};
  if (in_time->report.end != transient::MarchEnd::interrupted)
    return {not_converged, "not converged: " + why_incomplete(in_time)};
  std::string message = fmt::format("stopped at time {:g} a/u_m", in_time->report.T);
  if (!in_time->checkpoint && in_time->rows.size() < 2)
    message += ", before the first step";
  else if (!in_time->checkpoint)
    message +=
        ", without a checkpoint, which runs with [thermal] or [shear] flow = on and quasi-steady states do not keep: "
        "run "
        "the deck again";
  else if (!to_go_on.empty())
    message += "; continue with `" + to_go_on + "`";
  return {interrupted, message};
}

}  // namespace ehl::program
