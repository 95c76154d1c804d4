#pragma once
// A case from the deck to its result, the same for the program and for the C interface.
#include <string>
#include <vector>

#include "case/effects.hpp"
#include "commands/solver.hpp"
#include "results/outputs.hpp"

namespace ehl::program {

Solver solver_of(const Case& input);

/// Solves the case into `computed`: the contact first, then what its effects add.
/// errors: core::SolverError where there is nothing that could be shown; core::Interrupted.
void solve_case(const Case& input, RunSettings& settings, Computed& computed);

/// All that the result file holds. The content points to the fields of `computed`.
results::Content whole_content(const Case& input, const Computed& computed);

/// The content for a case in which the solver gave up: it has the film as far as there is one, else the deck, the
/// scales and the grid without fields. It is marked as not converged, with the reason.
results::Content content_without_solution(const Case& input, Computed& computed, const std::string& reason);

/// What `ehl run` prints of it. in: whether with the time of each part.
std::string printed(const Case& input, const Computed& computed, bool profile);

/// Why a result cannot have this name; empty where it can.
std::string unfit_as_result(const std::string& path);

/// The files that the deck of a case names, and those that its result will be. in: bytes that the first of them will
/// need.
std::vector<std::string> files_of(const Case& input);
std::vector<results::Output> result_outputs(const std::string& path, bool overwrite, std::size_t bytes);

/// How it ended: the exit status, and for one that is not `solved` why.
struct Ending {
  int status = 0;
  std::string message{};
};
/// in: the command that goes on with a run in time that was stopped, for the message; empty: there is none.
Ending ending_of(const Computed& computed, const std::string& to_go_on);

}  // namespace ehl::program
