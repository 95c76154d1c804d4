// ehl run, resume and check.
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "commands/commands.hpp"
#include "commands/solver.hpp"
#include "core/errors.hpp"
#include "core/timer.hpp"
#include "deck/document.hpp"
#include "deck/text.hpp"
#include "report/report.hpp"
#include "results/atomic_file.hpp"
#include "results/read.hpp"
#include "results/write.hpp"

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
    refuse("the result cannot be named " + to.path + ": .xmf is its companion; use .h5");
  if (!deck::is_utf8(to.path) || deck::has_control_character(to.path))
    refuse("the result cannot be named " + deck::quoted(to.path) +
           ": XDMF, which names it, takes UTF-8 without control characters: give another --output");
  std::vector<std::string> inputs{arguments.operands[0]};
  for (const deck::NamedFile& file : input.files) inputs.push_back(file.path);
  // P and the gap of a dry contact; single precision for stresses in space.
  std::size_t bytes = results::expected_bytes(input.scene.grid, input.dry ? 2 : input.fields.size());
  if (input.subsurface) {
    const core::Grid grid = subsurface::stress_grid(input.scene.grid, *input.subsurface);
    bytes += results::expected_bytes(grid, input.subsurface->kept.size()) / 2 *
             static_cast<std::size_t>(input.subsurface->planes);
  }
  results::check_writable(to.path, to.overwrite, bytes, inputs);
  results::check_writable(results::xdmf_name(to.path), to.overwrite, 0, inputs);
  return to;
}

int fail_without_solution(const Arguments& arguments, const Case& input, const std::string& reason) {
  if (arguments.has("json")) print(json_failure(input, reason));
  std::fprintf(stderr, "ehl: not converged: %s\nehl: no result was written\n", reason.c_str());
  return not_converged;
}

int status(const Computed& computed, const std::string& path) {
  const std::optional<TransientResult>& in_time = computed.in_time;
  if (!computed.solution.converged) {
    std::fprintf(stderr, "ehl: not converged: %s\n", computed.solution.failed_check.c_str());
    return computed.solution.accuracy.interrupted ? interrupted : not_converged;
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

std::string printed(const Case& input, const Solver& solver, const Computed& computed, bool profile) {
  std::string text = "case         " + input.title + "\n" + solver.summary(input, computed);
  for (const Effect& effect : effects_of(input))
    if (effect.summary) text += effect.summary(input, computed);
  text += effect_times(input, computed);
  if (profile && computed.in_time)
    text += profile_table(computed.in_time->report.times, computed.in_time->report.seconds);
  else if (profile && !input.dry)
    text += profile_table(computed.solution.times, computed.solution.seconds);
  return text + "memory       " + std::to_string(static_cast<long>(peak_memory() / 1e6)) + " MB at most\n";
}

Solver solver_of(const Case& input) { return input.dry ? dry_solver() : film_solver(); }

// Solves the case, the contact first, then what its effects add; says and saves what came out.
int solve_and_write(const Arguments& arguments, const Case& input, const Destination& to, TransientResult before) {
  const double began = core::now();
  const Solver solver = solver_of(input);
  Computed computed;
  bool overwrite = to.overwrite;
  const auto save = [&](const std::function<void(results::Content & content)>& add) {
    results::Content content = solver.content(input, computed);
    add(content);
    results::write(to.path, content, overwrite);
    overwrite = true;
  };
  try {
    Progress progress(arguments.has("quiet"));
    RunSettings settings{.progress = progress, .before = std::move(before), .save = save};
    solver.solve(input, progress, computed);
    for (const Effect& effect : effects_of(input))
      if (effect.compute) effect.compute(input, settings, computed);
  } catch (const core::SolverError& error) {
    return fail_without_solution(arguments, input, error.what());
  }
  computed.seconds = core::now() - began;
  // First of all: what is behind standard output may be full, or gone.
  save([&](results::Content& content) {
    for (const Effect& effect : effects_of(input))
      if (effect.add_content) effect.add_content(input, computed, content);
    content.effects = effect_rows(input, computed);
  });
  print(arguments.has("json")
            ? solver.json(input, computed)
            : printed(input, solver, computed, arguments.has("profile")) + "result       " + to.path + "\n");
  return status(computed, to.path);
}

// A run that goes on with another oil or load would be two runs in one file.
void check_same_files(const results::ResultFile& file, const Case& input) {
  if (file.kind("/provenance/files") == results::ResultFile::Kind::missing) return;  // none, or an older version's
  const std::string before = "\n" + file.text("/provenance/files") + "\n";
  for (const deck::NamedFile& one : input.files)
    if (before.find("\n" + deck::told(one) + "\n") == std::string::npos)
      throw core::FileError(one.path + ": has changed since the run began: " + file.path() + " cannot go on with it");
}

}  // namespace

int run(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.overrides(), requested_threads(arguments));
  return solve_and_write(arguments, input, destination(arguments, input), {});
}

int resume(const Arguments& arguments) {
  const std::string path = arguments.operands[0];
  const results::ResultFile file(path);
  TransientResult before = read_transient(file);
  const deck::Document document = deck::parse(file.text("/deck"), path + " /deck");
  deck::Deck understood = deck::validate(document, {}, catalogue());
  if (file.kind("/provenance/deck_folder") != results::ResultFile::Kind::missing)
    understood.folders.push_back(file.text("/provenance/deck_folder"));
  understood.folders.push_back(std::filesystem::absolute(path).parent_path().string());
  const Case input = case_of(std::move(understood), path, requested_threads(arguments));
  if (!input.transient) throw core::FileError(path + ": the file is damaged: its deck is of no run in time");
  check_fits(before, input, path);
  check_same_files(file, input);
  std::vector<std::string> inputs;
  for (const deck::NamedFile& one : input.files) inputs.push_back(one.path);
  results::check_writable(path, true, results::expected_bytes(input.scene.grid, input.fields.size()), inputs);
  return solve_and_write(arguments, input, {path, true}, std::move(before));
}

int check(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.overrides(), requested_threads(arguments));
  print(solver_of(input).derived(input));
  return solved;
}

}  // namespace ehl::program
