#pragma once
// The numbers that people ask a solution for.
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

Outcome outcome_of(const Case& input, const steady::Solution& solution);

/// Code of the film that is fitted to our own solutions (contact/film_map.hpp) among the formulas.
constexpr char map_code[] = "map";

/// Published film formulas for a case, the same for `run` and `check`: those that were made for its shape.
std::vector<Formula> film_formulas(const contact::Groups& groups);
/// Which are not among them, and why; empty where none is missing.
std::string formulas_left_out(const contact::Groups& groups);

/// A word for the way that led to a solution, for scripts and plots: full-multigrid, full-multigrid-2 (from another
/// start), load-continuation, newton, newton-after-cycles; none.
std::string path_code(const steady::Solution& solution);

const char* name(reynolds::Wedge wedge);
const char* name(reynolds::Face face);
const char* name(mlmi::Method method);

}  // namespace ehl::program
