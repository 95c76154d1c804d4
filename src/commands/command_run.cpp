// ehl run, resume and check.
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/exit_status.hpp"
#include "case/catalogue.hpp"
#include "case/effects.hpp"
#include "commands/commands.hpp"
#include "core/errors.hpp"
#include "deck/document.hpp"
#include "results/outputs.hpp"
#include "results/read.hpp"
#include "results/write.hpp"
#include "run/pipeline.hpp"

namespace ehl::program {
namespace {

struct Destination {
  std::string path;
  bool overwrite = false;
  bool is_completed = false;  // the file holds a run in time that is continued
};

// Checks the files before the computation begins.
Destination destination(const Arguments& arguments, const Case& input) {
  Destination to{arguments.value("output", input.output), arguments.has("overwrite")};
  if (const std::string why = unfit_as_result(to.path); !why.empty()) refuse(why + "; give another --output");
  std::vector<std::string> inputs = files_of(input);
  inputs.push_back(arguments.operands[0]);
  // The fields are P and the gap for a dry contact; subsurface stresses are stored in single precision.
  std::size_t bytes = results::expected_bytes(input.scene.grid, input.dry ? 2 : input.fields.size());
  if (input.subsurface) {
    const core::Grid grid = subsurface::stress_grid(input.scene.grid, *input.subsurface);
    bytes += results::expected_bytes(grid, input.subsurface->kept.size()) / 2 *
             static_cast<std::size_t>(input.subsurface->planes);
  }
  results::check_files(inputs, result_outputs(to.path, to.overwrite, bytes));
  return to;
}

// Solves the case, saves the result and prints the report.
int solve_and_write(const Arguments& arguments, const Case& input, const Destination& to, TransientResult before) {
  Computed computed;
  std::string held;
  {
    Progress progress(arguments.has("quiet"));
    RunSettings settings{.progress = progress, .before = std::move(before)};
    bool overwrite = to.overwrite;
    held = solve_and_save(input, std::move(settings), computed, to.is_completed, [&](const results::Content& content) {
      results::write(to.path, content, overwrite);
      overwrite = true;
    });
  }
  // The file is written before the report is printed: standard output may be full or closed.
  const bool is_solved = computed.unsolved.empty();
  if (arguments.has("json"))
    print(json_of(input, computed));
  else if (is_solved)
    print(printed(input, computed, arguments.has("profile")) + "result       " + to.path + "\n");
  const Ending ending = ending_of(computed, "ehl resume " + to.path);
  if (!ending.message.empty()) std::fprintf(stderr, "ehl: %s\n", ending.message.c_str());
  if (!is_solved) std::fprintf(stderr, "ehl: %s contains %s\n", to.path.c_str(), held.c_str());
  return ending.status;
}

// A run must not be continued with another oil or load.
void check_same_files(const results::ResultFile& file, const Case& input) {
  // No files were named, or an older version wrote the result.
  if (file.kind("/provenance/files") == results::ResultFile::Kind::missing) return;
  const std::string before = "\n" + file.text("/provenance/files") + "\n";
  for (const deck::NamedFile& one : input.files)
    if (before.find("\n" + deck::fingerprint(one) + "\n") == std::string::npos)
      throw core::FileError(one.path + ": has changed since the run began: " + file.path() +
                            " cannot be continued with it");
}

}  // namespace

int run(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.overrides(), requested_threads(arguments));
  return solve_and_write(arguments, input, destination(arguments, input), {});
}

int resume(const Arguments& arguments) {
  const std::string path = arguments.operands[0];
  const results::ResultFile file(path);
  require_checkpoint(file);
  const deck::Document document = deck::parse(file.text("/deck"), path + " /deck");
  deck::Deck understood = deck::validate(document, {}, catalogue());
  if (file.kind("/provenance/deck_folder") != results::ResultFile::Kind::missing)
    understood.folders.push_back(file.text("/provenance/deck_folder"));
  understood.folders.push_back(std::filesystem::absolute(path).parent_path().string());
  const Case input = case_of(std::move(understood), path, requested_threads(arguments));
  if (!input.transient) throw core::FileError(path + ": the file is damaged: its deck is not that of a run in time");
  TransientResult before = read_transient(file, input);
  check_fits(before, input, path);
  check_same_files(file, input);
  // The result is both read and written: it is continued in place.
  results::check_files(files_of(input),
                       result_outputs(path, true, results::expected_bytes(input.scene.grid, input.fields.size())));
  return solve_and_write(arguments, input, {path, true, true}, std::move(before));
}

int check(const Arguments& arguments) {
  const Case input = read_case(arguments.operands[0], arguments.overrides(), requested_threads(arguments));
  print(derived_of(input));
  return solved;
}

}  // namespace ehl::program
