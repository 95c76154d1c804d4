#pragma once
// Runs a transient and keeps what comes out: the numbers of every step, and the fields at the times asked for.
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "case/scene.hpp"
#include "results/content.hpp"
#include "results/read.hpp"
#include "transient/march.hpp"

namespace ehl::program {

struct TransientResult {
  std::vector<transient::StepRow> rows{};
  std::vector<transient::Frame> frames{};
  transient::MarchReport report{};
  std::optional<transient::Checkpoint> checkpoint{};  ///< where it can go on; nothing where it is complete
};

/// From the steady solution of the case; or, where `before` has a checkpoint, on from there, with all that it had.
/// save: called with what there is at every checkpoint. errors: core::SolverError where the state at time 0 is not
/// found.
TransientResult run_transient(const Case& input, const steady::Solution& start, Progress& progress,
                              TransientResult before, const std::function<void(const TransientResult& so_far)>& save);

/// True where it came to its end: the end time, or what the deck says that it stops at.
bool completed(const TransientResult& result);

/// "at the end time", "interrupted", ...
std::string how_it_ended(const transient::MarchReport& report);

/// "the transient ended at time 2 a/u_m: the cycles did not converge", "the transient was interrupted at time 2 a/u_m";
/// empty where it is complete, or the case steady.
std::string why_incomplete(const std::optional<TransientResult>& result);

/// What a person wants to know.
std::string transient_summary(const Case& input, const TransientResult& result);

/// The same as a JSON object.
nlohmann::ordered_json transient_json(const Case& input, const TransientResult& result);

/// Adds /transient, and /checkpoint where there is one, to the content of a result file; the result must outlive it.
void add_transient(const Case& input, const TransientResult& result, results::Content& content);

/// The same back from a result file. errors: core::InputError where the file has no checkpoint; core::FileError: a
/// number that none of this program's can be.
TransientResult read_transient(const results::ResultFile& file);

/// Whether it can be the beginning of this case's run. in: name of the file. errors: core::FileError.
void check_fits(const TransientResult& before, const Case& input, const std::string& path);

}  // namespace ehl::program
