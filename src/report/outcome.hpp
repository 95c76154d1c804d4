#pragma once
// The numbers that people ask a solution for.
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

Outcome outcome_of(const Case& input, const steady::Solution& solution);

/// Film formulas for a case, the same for `run` and `check`: the published ones that were made for its shape, and the
/// fit to our own solutions where it reaches (report/film_fit.hpp).
std::vector<Formula> film_formulas(const Physics& physics);
/// Which are not among them, and why; empty where none is missing.
std::string formulas_left_out(const contact::Groups& groups);

/// A word for the way that led to a solution, for scripts and plots: full-multigrid, full-multigrid-2 (from another
/// start), load-continuation, newton, newton-after-cycles; none.
std::string path_code(const steady::Solution& solution);

const char* name(reynolds::Wedge wedge);
const char* name(reynolds::Face face);
const char* name(mlmi::Method method);

}  // namespace ehl::program
