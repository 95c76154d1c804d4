#pragma once
// When the cycles on a level are enough, and when a solution may be called converged.
#include <limits>
#include <string>

#include "judgement/measures.hpp"

namespace ehl::judgement {

/// A larger discretization error than this is no licence to stop earlier: its estimate is too uncertain.
inline constexpr double largest_licence = 0.05;

/// Of the oil that comes in, where mass is conserved; rounding leaves 1e-13 on 513^2.
inline constexpr double largest_oil_imbalance = 1e-10;

/// Two states of the finest level, one cycle apart, and what is known of the discretization error there.
struct LastCycle {
  Measures before;
  Measures after;
  double error_Hc = 0.0;  ///< estimated relative discretization error; NaN where unknown
  double error_Hm = 0.0;
  bool first = false;  ///< the first cycle after an interpolation: its change foretells little
};

/// What further cycles would still change in Hc or Hm, relative: the last cycle's change times q/(1 - q), q the factor
/// by which that cycle reduced the residual, held between 0.25 (0.5 for a first cycle) and 0.9. in: value =
/// &Measures::Hc or Hm.
double foretold_error(const LastCycle& cycle, double Measures::*value);

/// The first check that the state does not pass, as a sentence with numbers and a remedy; empty when it passes all.
///   Film positive and P >= 0 everywhere.
///   With a tolerance, and with 1e-6 where the discretization error is unknown (one level): relative residual and load
///   error at or below it. With tolerance NaN: residual and load error small (4e-3, 1e-4), and the algebraic error of
///   Hc and Hm, as foretold_error has it, below a twentieth of the discretization error.
///   No cavitated node that wants pressure, by more than 2e-2 of the wedge term.
///   Mass conserved around the contact (Measures::flow_imbalance): to a quarter of the discretization error of Hc,
///   or 1e-4 where that is smaller.
/// The README of this module says what the limits were measured on.
std::string unmet_check(const LastCycle& cycle, double tolerance);

/// What is wrong with the oil of a steady film, likewise: it balances to 1e-10.
std::string unmet_oil(const Measures& now);

/// The same for a level below the finest, whose solution is only a start: positive film, and the algebraic error of Hc
/// and Hm as above.
std::string unmet_film(const LastCycle& cycle);

/// What the cycles on a level are for.
enum class Aim {
  first_start,  ///< the first grid, from which the others start: its film has settled
  start,        ///< a level below the finest: its film, as unmet_film has it
  solution,     ///< the finest: all checks, as unmet_check has it
  residual      ///< residual and load error at or below the tolerance, and nothing else
};

/// When to stop.
struct StoppingCriterion {
  Aim aim = Aim::solution;
  int planned = 2;                                              ///< cycles at least; with a tolerance, none
  int most = 60;                                                ///< cycles at most
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the level of the discretization error
  double of_start = std::numeric_limits<double>::infinity();    ///< largest relative residual of a start
};

/// More cycles cannot mend it: the equations are solved, by a film that is negative.
bool no_solution(const Measures& now);

struct Verdict {
  std::string unmet;  ///< what is wrong with the state; empty when nothing
  bool no_solution = false;
};

/// The criterion on the states before and after a cycle, numbered from 1.
Verdict judged(const StoppingCriterion& criterion, int cycle, const LastCycle& last);

}  // namespace ehl::judgement
