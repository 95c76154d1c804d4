#pragma once
// Computes a case from the deck to its result, for the program and for the C interface.
#include <string>
#include <vector>

#include "case/effects.hpp"
#include "commands/solver.hpp"
#include "results/outputs.hpp"

namespace ehl::program {

/// The solver for the kind of contact of the case.
Solver solver_of(const Case& input);

/// Solves the case into `computed`: first the contact, then the effects.
/// errors: core::SolverError if there is nothing to show; core::Interrupted.
void solve_case(const Case& input, RunSettings& settings, Computed& computed);

/// The whole content of the result file. It points to the fields of `computed`.
results::Content whole_content(const Case& input, const Computed& computed);

/// The content for a case that the solver could not solve: the film as far as it was computed, else the deck, the
/// scales and the grid without fields. It is marked as not converged, with the reason.
results::Content content_without_solution(const Case& input, Computed& computed, const std::string& reason);

/// The report of `ehl run`. in: profile: whether to print the time of each part.
std::string printed(const Case& input, const Computed& computed, bool profile);

/// The reason why a result cannot have this name; empty if it can.
std::string unfit_as_result(const std::string& path);

/// The files that the deck of a case names, and the files that its result will consist of. in: bytes:
/// expected size of the result.
std::vector<std::string> files_of(const Case& input);
std::vector<results::Output> result_outputs(const std::string& path, bool overwrite, std::size_t bytes);

/// How the run ended: the exit status and, if it is not `solved`, the reason.
struct Ending {
  int status = 0;
  std::string message{};
};
/// in: to_go_on: the command that continues a run in time that was stopped, for the message; empty: there is none.
Ending ending_of(const Computed& computed, const std::string& to_go_on);

}  // namespace ehl::program
