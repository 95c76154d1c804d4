#pragma once
// When a solution may be called converged.
#include <string>

#include "steady/state_of_level.hpp"

namespace ehl::steady {

/// Two states of the finest level, one cycle apart, and what is known of the discretization error there.
struct LastCycle {
  StateOfLevel before;
  StateOfLevel after;
  double error_Hc = 0.0;  ///< estimated relative discretization error; NaN where unknown
  double error_Hm = 0.0;
};

/// What further cycles would still change in Hc or Hm, relative: the last cycle's change times q/(1 - q), q the factor
/// by which that cycle reduced the residual, held between 0.25 and 0.9. in: value = &StateOfLevel::Hc or Hm.
double foretold_error(const LastCycle& cycle, double StateOfLevel::*value);

/// The first check that the state does not pass, as a sentence with numbers and a remedy; empty when it passes all.
/// With a tolerance: relative residual and load error at or below it. With NaN: algebraic error of Hc and Hm, as the
/// last cycle's change and its factor foretell it, below a twentieth of the discretization error; residual and load
/// error small; and where the discretization error is unknown (one level), a relative residual of 1e-6. In both: a
/// positive film everywhere.
std::string unmet_check(const LastCycle& cycle, double tolerance);

}  // namespace ehl::steady
