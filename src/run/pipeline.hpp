#pragma once
// The one way from a case to its result: solve -> outcome -> effects -> save -> say. The commands, the rows of sweeps,
// the points of studies and the C interface all take it, as far as they ask (Extent).
#include <functional>
#include <string>
#include <vector>

#include "case/effects.hpp"
#include "results/outputs.hpp"

namespace ehl::program {

/// Solves the case into `computed`: the contact and its main numbers, then the effects, up to settings.extent.
/// Computed::unsolved says why there is nothing to show. errors: core::Interrupted.
void solve_case(const Case& input, RunSettings& settings, Computed& computed);

/// The part of it that follows the contact, also for a larger extent than that for which the case was solved.
/// errors: core::SolverError; core::Interrupted.
void compute_effects(const Case& input, RunSettings& settings, Computed& computed);

/// solve_case(), and writes the result, also of a case without solution, and the result so far of a run in time.
/// in: is_continued: the result file already holds a part of this run. out: what the file then holds, for a reader.
std::string solve_and_save(const Case& input, RunSettings settings, Computed& computed, bool is_continued,
                           const std::function<void(const results::Content& content)>& write);

/// The whole content of the result file. It points to the fields of `computed`. Without a solution: the film as far as
/// it was computed, else the deck, the scales and the grid without fields; marked as not converged, with the reason.
results::Content whole_content(const Case& input, const Computed& computed);

/// The report of `ehl run`. in: profile: whether to print the time of each part.
std::string printed(const Case& input, const Computed& computed, bool profile);
/// The JSON object of `ehl run --json`, also of a case without solution.
std::string json_of(const Case& input, const Computed& computed);
/// The report of `ehl check`.
std::string derived_of(const Case& input);

/// The reason why a result cannot have this name; empty if it can.
std::string unfit_as_result(const std::string& path);

/// The files that the deck of a case names, and the files that its result will consist of. in: bytes:
/// expected size of the result.
std::vector<std::string> files_of(const Case& input);
std::vector<results::Output> result_outputs(const std::string& path, bool overwrite, std::size_t bytes);

/// How the case ended: the exit status and, if it is not `solved`, the reason.
struct Ending {
  int status = 0;
  std::string message{};
};
/// in: to_go_on: the command that continues a run in time that was stopped, for the message; empty: there is none.
Ending ending_of(const Computed& computed, const std::string& to_go_on);

}  // namespace ehl::program
