#pragma once
// Runs a transient and keeps what comes out: the numbers of every step, and the fields at the times asked for.
#include <string>
#include <vector>

#include "result_content.hpp"
#include "scene.hpp"
#include "transient/march.hpp"

namespace ehl::program {

struct TransientResult {
  std::vector<transient::StepRow> rows{};
  std::vector<transient::Frame> frames{};
  transient::MarchReport report{};
};

/// From the steady solution of the case. errors: core::SolverError where the state at time 0 is not found.
TransientResult run_transient(const Case& input, const steady::Solution& start, bool quiet);

/// True where it came to its end: the end time, or what the deck says that it stops at.
bool completed(const TransientResult& result);

/// What a person wants to know.
std::string transient_summary(const Case& input, const TransientResult& result);

/// The same as a JSON object.
std::string transient_json(const TransientResult& result);

/// Adds /transient to the content of a result file; the result must outlive it.
void add_transient(const Case& input, const TransientResult& result, results::Content& content);

}  // namespace ehl::program
