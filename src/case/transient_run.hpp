#pragma once
// Computes a run in time and collects its results: numbers at every step, and fields at the times asked for.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/si_units.hpp"
#include "case/scene.hpp"
#include "results/content.hpp"
#include "results/read.hpp"
#include "transient/march.hpp"

namespace ehl::program {

struct RunSettings;

/// Error bars of a run in time, from runs on half the cells and with a larger tolerance.
struct TimeErrors {
  std::map<std::string, double> of{};  ///< relative, of extremes and means, by their names in the registry
  std::string missing{};               ///< why there are none
  double seconds = 0.0;                ///< of these runs
};

struct TransientResult {
  std::vector<transient::StepRow> rows{};
  std::vector<transient::Frame> frames{};
  transient::MarchReport report{};
  std::optional<transient::MarchReport> states{};  ///< of the quasi-steady states, if the mode has any
  std::vector<std::string> measured{};      ///< what the effects add to the rows, in the order of StepRow::measured
  std::map<std::string, double> seconds{};  ///< of the effects that compute at steps, by name; part of report.seconds
  std::optional<TimeErrors> errors{};       ///< if the deck asks for them
  std::optional<transient::Checkpoint> checkpoint{};  ///< where an incomplete run continues; else empty
};

/// Starts from the steady solution of the case or, if settings.before has a checkpoint, continues from there and keeps
/// its results. The results so far are saved at every checkpoint. errors: core::SolverError if the state at time 0 is
/// not found.
TransientResult run_transient(const Case& input, const steady::Solution& start, RunSettings& settings);

/// True if the run reached its end: the end time, or the event at which the deck lets it stop.
bool completed(const TransientResult& result);

/// "at the end time", "interrupted", ...
std::string how_it_ended(const transient::MarchReport& report);

/// Why a run is incomplete: "the transient ended at time 2 a/u_m: the cycles did not converge", "the transient was
/// interrupted at time 2 a/u_m"; empty if it is complete or the case is steady.
std::string why_incomplete(const std::optional<TransientResult>& result);

/// The unit of printed times: ms if the deck gives times in seconds.
SiUnit time_unit(const Case& input);

/// The printed summary.
std::string transient_summary(const Case& input, const TransientResult& result);

/// Adds /transient, and /checkpoint if there is one, to the content of a result file. The content points into `result`.
void add_transient(const Case& input, const TransientResult& result, results::Content& content);

/// errors: core::InputError if the file has no checkpoint from which the run can continue.
void require_checkpoint(const results::ResultFile& file);
/// Reads the run of a case back from its result file, which has a checkpoint. errors: core::FileError if a number
/// cannot come from this program.
TransientResult read_transient(const results::ResultFile& file, const Case& input);

/// Checks that an earlier run can be continued as this case. in: path: name of its file. errors: core::FileError.
void check_fits(const TransientResult& before, const Case& input, const std::string& path);

}  // namespace ehl::program
