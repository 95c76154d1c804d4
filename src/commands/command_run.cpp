// ehl run, check and keys.
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <utility>

#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "commands/commands.hpp"
#include "commands/dry_run.hpp"
#include "commands/exit_status.hpp"
#include "commands/machine.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "deck/write.hpp"
#include "report/progress.hpp"
#include "report/report.hpp"
#include "report/result_content.hpp"
#include "results/atomic_file.hpp"
#include "results/read.hpp"
#include "results/write.hpp"
#include "steady/solve.hpp"

namespace ehl::program {
namespace {

struct Destination {
  std::string path;
  bool overwrite;
};

// Before the work, not after it.
Destination destination(const Arguments& arguments, const Case& input) {
  Destination to{arguments.value("output", input.output), arguments.has("overwrite")};
  if (results::xdmf_name(to.path) == to.path)
    throw core::InputError("command line: the result cannot be named " + to.path + ": .xmf is its companion; use .h5");
  // P and the gap of a dry contact; single precision for stresses in space.
  std::size_t bytes = results::expected_bytes(input.scene.grid, input.dry ? 2 : input.fields.size());
  if (input.subsurface) {
    const core::Grid grid = subsurface::stress_grid(input.scene.grid, *input.subsurface);
    bytes += results::expected_bytes(grid, input.subsurface->kept.size()) / 2 *
             static_cast<std::size_t>(input.subsurface->planes);
  }
  results::check_writable(to.path, to.overwrite, bytes);
  results::check_writable(results::xdmf_name(to.path), to.overwrite, 0);
  return to;
}

int fail_without_solution(const Arguments& arguments, const Case& input, const std::string& reason) {
  if (arguments.has("json")) print(json_failure(input, reason));
  std::fprintf(stderr,
               "ehl: not converged: %s\nehl: no result was written. Try more cells, a larger domain or a "
               "lighter load.\n",
               reason.c_str());
  return not_converged;
}

int status(const Computed& computed, const std::string& path) {
  const auto& [solution, in_time, stresses, friction, seconds] = computed;
  if (!solution.converged) {
    std::fprintf(stderr, "ehl: not converged: %s\n", solution.failed_check.c_str());
    return not_converged;
  }
  if (!in_time || completed(*in_time)) return solved;
  if (in_time->report.end == transient::MarchEnd::interrupted) {
    const std::string then = in_time->checkpoint ? "; go on with `ehl resume " + path + "`" : ", before the first step";
    std::fprintf(stderr, "ehl: stopped at time %g a/u_m%s\n", in_time->report.T, then.c_str());
    return interrupted;
  }
  std::fprintf(stderr, "ehl: not converged: the transient ended at time %g a/u_m: %s\n", in_time->report.T,
               in_time->report.reason.c_str());
  return not_converged;
}

std::string printed(const Case& input, const Computed& computed, const Outcome& outcome, bool profile) {
  const auto& [solution, in_time, stresses, friction, seconds] = computed;
  std::string text = "case         " + input.title + "\n" + continuation_table(input, solution) +
                     level_table(solution) + summary(input, solution, outcome);
  for (const Effect& effect : effects_of(input))
    if (effect.summary) text += effect.summary(input, computed);
  text += effect_times(input, computed);
  if (profile)
    text += profile_table(in_time ? in_time->report.times : solution.times,
                          in_time ? in_time->report.seconds : solution.seconds);
  return text + "memory       " + std::to_string(static_cast<long>(peak_memory() / 1e6)) + " MB at most\n";
}

// Solves the case, the steady contact first, then what its effects add.
int solve_and_write(const Arguments& arguments, const Case& input, const Destination& to, TransientResult before) {
  const double began = core::now();
  Computed computed;
  steady::Solution& solution = computed.solution;
  try {
    ProgressReport progress(arguments.has("quiet"));
    solution = steady::solve(input.scene, [&](const steady::Progress& now) { return progress.show(now); });
  } catch (const core::SolverError& error) {
    return fail_without_solution(arguments, input, error.what());
  }

  // No start led to a state that could be shown.
  if (solution.levels.empty() || solution.H.nodes_x() == 0)
    return fail_without_solution(arguments, input, solution.failed_check);
  const Outcome outcome = outcome_of(input, solution);
  if (!std::isfinite(outcome.Hc + outcome.Hm.value + outcome.P_max.value))
    return fail_without_solution(arguments, input, "the film or the pressure is not finite");

  const DerivedFields derived = derived_fields(input, solution);
  bool overwrite = to.overwrite;
  const auto save = [&](const std::function<void(results::Content & content)>& add) {
    results::Content content = result_content(input, solution, outcome, derived);
    add(content);
    results::write(to.path, content, overwrite);
    overwrite = true;
  };
  RunSettings settings{.quiet = arguments.has("quiet"), .before = std::move(before), .save = save};
  try {
    for (const Effect& effect : effects_of(input))
      if (effect.compute) effect.compute(input, settings, computed);
  } catch (const core::SolverError& error) {
    return fail_without_solution(arguments, input, error.what());
  }
  computed.seconds = core::now() - began;
  if (arguments.has("json"))
    print(json_report(input, computed, outcome, peak_memory()));
  else
    print(printed(input, computed, outcome, arguments.has("profile")));
  save([&](results::Content& content) {
    for (const Effect& effect : effects_of(input))
      if (effect.add_content) effect.add_content(input, computed, content);
    content.effects = effect_rows(input, computed);
  });
  if (!arguments.has("json")) print("result       " + to.path + "\n");
  return status(computed, to.path);
}

}  // namespace

int requested_threads(const Arguments& arguments) { return whole_number(arguments, "threads", usable_cores(), 1024); }

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw core::FileError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

int run(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.values("set"), requested_threads(arguments));
  const Destination to = destination(arguments, input);
  if (!input.dry) return solve_and_write(arguments, input, to, {});
  try {
    return run_dry(arguments, input, to.path, to.overwrite);
  } catch (const core::SolverError& error) {
    return fail_without_solution(arguments, input, error.what());
  }
}

int resume(const Arguments& arguments) {
  const std::string path = arguments.operands[0];
  const results::ResultFile file(path);
  TransientResult before = read_transient(file);
  const deck::Document document = deck::parse(file.text("/deck"), path + " /deck", catalogue());
  deck::Deck understood = deck::validate(document, {}, catalogue());
  if (file.kind("/provenance/deck_folder") != results::ResultFile::Kind::missing)
    understood.folders.push_back(file.text("/provenance/deck_folder"));
  understood.folders.push_back(std::filesystem::absolute(path).parent_path().string());
  const Case input = case_of(std::move(understood), path, requested_threads(arguments));
  results::check_writable(path, true, results::expected_bytes(input.scene.grid, input.fields.size()));
  return solve_and_write(arguments, input, {path, true}, std::move(before));
}

int check(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.values("set"), requested_threads(arguments));
  print(input.dry ? derived_dry(input) : derived(input));
  return solved;
}

int keys(const Arguments& arguments) {
  const std::string selection = arguments.operands.empty() ? "" : arguments.operands[0];
  if (arguments.has("deck") && !selection.empty())
    throw core::InputError("command line: `ehl keys --deck` writes the whole deck: leave " + selection + " out");
  print(arguments.has("deck") ? deck::commented_deck(catalogue()) : deck::list_keys(catalogue(), selection));
  return solved;
}

}  // namespace ehl::program
