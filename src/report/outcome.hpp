#pragma once
// The numbers that people ask a solution for.
#include <string>
#include <vector>

#include "case/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::program {

/// A value of a field and where it is, in Hertz radii.
struct Place {
  double value = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// Central and minimum film by a published formula, as H = h R/a^2; NaN: the formula does not say.
struct Formula {
  std::string name{};
  double Hc = 0.0;
  double Hm = 0.0;
};

/// NaN: not known in this case (nanometres of a dimensionless contact).
struct Outcome {
  double Hc = 0.0;
  Place Hm{};
  Place P_max{};
  double Hc_moes = 0.0;
  double Hm_moes = 0.0;
  double hc = 0.0;  ///< [m]
  double hm = 0.0;  ///< [m]
  std::vector<Formula> formulas{};
  std::string regime{};
  std::vector<std::string> warnings{};
};

Outcome outcome_of(const Case& input, const steady::Solution& solution);

/// Published film formulas for a case, the same for `run` and `check`: those that were made for its shape.
std::vector<Formula> film_formulas(const contact::Groups& groups);
/// Which are not among them, and why; empty where none is missing.
std::string formulas_left_out(const contact::Groups& groups);

/// A word for the way that led to a solution, for scripts and plots: full-multigrid, full-multigrid-2 (from another
/// start), load-continuation, newton, newton-after-cycles; none.
std::string path_code(const steady::Solution& solution);

const char* name(reynolds::Wedge wedge);
const char* name(mlmi::Method method);

}  // namespace ehl::program
