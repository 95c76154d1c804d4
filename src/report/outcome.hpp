#pragma once
// The main numbers of a solution.
#include <string>
#include <vector>

#include "case/computed.hpp"
#include "case/scene.hpp"

namespace ehl::program {

/// Film, pressure, their places, formulas, roughness and warnings of a solution; in SI if the case has scales.
Outcome outcome_of(const Case& input, const steady::Solution& solution);
bool has_film(const steady::Solution& solution);
bool is_finite(const Outcome& outcome);

/// The film formulas for a case, the same for `run` and `check`: the published formulas made for its shape, and the fit
/// to solutions of this program if the case is in its range (report/film_fit.hpp).
std::vector<Formula> film_formulas(const Physics& physics);
/// Which formulas are missing, and why; empty if none is missing.
std::string formulas_left_out(const contact::Groups& groups);

/// The names of a wedge, a face value and a deformation method in decks.
const char* name(reynolds::Wedge wedge);
const char* name(reynolds::Face face);
const char* name(mlmi::Method method);

}  // namespace ehl::program
