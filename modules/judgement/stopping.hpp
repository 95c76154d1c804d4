#pragma once
// When the cycles on a level may stop, and when a solution counts as converged.
#include <limits>
#include <string>

#include "judgement/measures.hpp"
#include "judgement/tuning.hpp"

namespace ehl::judgement {

/// Two states of the finest level, one cycle apart, and the estimated discretization error.
struct LastCycle {
  Measures before;
  Measures after;
  double mesh_error_Hc = 0.0;  ///< estimated relative discretization error; NaN if unknown
  double mesh_error_Hm = 0.0;
};

/// Estimated algebraic error of Hc or Hm, relative: the last cycle's change times q/(1 - q). q is the convergence
/// factor of that cycle, limited to [0.25, 0.9]. in: value = &Measures::Hc or &Measures::Hm.
double predicted_error(const Tuning& tuning, const LastCycle& cycle, double Measures::*value);

/// The first check that the state fails, as a sentence with numbers and a remedy; empty if it passes all.
///   Film positive and P >= 0 everywhere.
///   With a tolerance (1e-6 if the discretization error is unknown, as with one level): relative residual and load
///   error at most the tolerance. With tolerance NaN: residual and load error at most 4e-3 and 1e-4, and the estimated
///   algebraic error of Hc and Hm below a twentieth of the discretization error.
///   Complementarity: no cavitated node that calls for pressure with a residual above 2e-2 of the wedge term.
///   Mass conserved around the contact (Measures::flow_imbalance) to a quarter of the discretization error of Hc, or to
///   1e-4 if that is larger.
std::string unmet_check(const Tuning& tuning, const LastCycle& cycle, double tolerance);

/// The failed check of the oil of a steady film, as a sentence; empty if it balances to Tuning::largest_oil_imbalance
/// and the oil content is nowhere negative.
std::string unmet_oil(const Tuning& tuning, const Measures& now);

/// The failed check of a level below the finest, whose solution is only a start: positive film, and the algebraic error
/// of Hc and Hm as in unmet_check(); empty if it passes.
std::string unmet_film(const Tuning& tuning, const LastCycle& cycle);

/// The purpose of the cycles on a level.
enum class Aim {
  first_start,  ///< the first grid, from which the finer ones start: its film has settled
  start,        ///< a level below the finest: unmet_film()
  solution,     ///< the finest level: all of unmet_check()
  residual      ///< only residual and load error at most the tolerance
};

/// The stopping criterion of the cycles.
struct StoppingCriterion {
  Aim aim = Aim::solution;
  int planned = 2;                                              ///< least number of cycles; none with a tolerance
  int most = 60;                                                ///< largest number of cycles
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the level of the discretization error
  double of_start = std::numeric_limits<double>::infinity();    ///< largest relative residual of a start
};

/// True if further cycles cannot help: the equations are solved, but by a film that is negative.
bool no_solution(const Tuning& tuning, const Measures& now);

struct Verdict {
  std::string unmet;  ///< the check that failed, empty if none
  bool no_solution = false;
};

/// Applies the criterion to the states before and after a cycle, numbered from 1.
Verdict judged(const Tuning& tuning, const StoppingCriterion& criterion, int cycle, const LastCycle& last);

}  // namespace ehl::judgement
