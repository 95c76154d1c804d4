#pragma once
// What a steady computation gives back.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "adjoint/errors.hpp"
#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/timer.hpp"
#include "fmg/record.hpp"
#include "judgement/verification.hpp"
#include "newton/solve.hpp"
#include "reynolds/flow_balance.hpp"
#include "steady/error_bars.hpp"
#include "steady/starvation.hpp"

namespace ehl::steady {

using fmg::CycleRow;
using fmg::CyclesEnd;
using fmg::LevelRow;
using judgement::Verification;

/// One way to the solution that was tried.
struct Attempt {
  std::string method;  ///< e.g. "full multigrid", "load continuation"
  std::string reason;  ///< why it did not lead to a solution; empty where it did
  double seconds = 0.0;
};

/// One step of a load continuation, the rejected ones included.
struct ContinuationStep {
  double M = 0.0;
  double load_ratio = 1.0;                               ///< to the load of the scene
  double Hc = std::numeric_limits<double>::quiet_NaN();  ///< NaN: its first cycle diverged
  double Hm = std::numeric_limits<double>::quiet_NaN();
  double residual = std::numeric_limits<double>::quiet_NaN();
  int cycles = 0;
  bool converged = false;
};

/// What became of the accuracy that was asked for.
struct AccuracyReport {
  double asked = std::numeric_limits<double>::quiet_NaN();  ///< NaN: none
  bool met = false;
  bool by_extrapolation = false;  ///< met by the extrapolated values, not by the plain ones
  std::string stopped_by;         ///< empty when met: what stood in the way
  bool interrupted = false;       ///< by the user: the solution is of the finest grid that was solved
};

struct Solution {
  core::Grid grid;
  core::Field P;
  core::Field H;
  double H00 = 0.0;
  core::Field Q;                            ///< where the scene has a supply: the content, oil per area; else empty
  core::Field theta;                        ///< Q/(rho_bar H)
  reynolds::OilBalance oil;                 ///< likewise
  double C_centre = 1.0;                    ///< rho_bar H C is carried at (0, 0): 1 without heat
  int swinging_nodes = 0;                   ///< that found no state (fmg/swinging.hpp)
  std::optional<Starvation> starvation;     ///< where the scene has a supply
  std::vector<Pass> passes;                 ///< where the scene asks for more than one; the rest is of the last
  std::vector<std::vector<double>> tracks;  ///< what each of them left behind, per line of the domain, in units of H
  bool converged = false;
  std::string failed_check;      ///< empty when converged: else which level, which check, what to try
  std::vector<LevelRow> levels;  ///< coarse to fine; the last is the result
  std::vector<CycleRow> history;
  core::PartTimes times;
  std::string deformation;  ///< what evaluated the film, for the report
  std::vector<std::string> warnings;
  double seconds = 0.0;
  CyclesEnd end = CyclesEnd::content;  ///< on the finest grid
  std::string method;                  ///< of the attempt that led to what is shown
  std::vector<Attempt> attempts;
  std::vector<ContinuationStep> continuation;
  std::vector<newton::Step> newton;  ///< on the finest grid
  std::string polish_failure;        ///< why Newton's method after the cycles did not reach rounding errors
  /// Residual after a cycle over that before it, geometric mean of the cycles on the finest grid but the first; NaN
  /// where there are fewer than two.
  double cycle_factor = std::numeric_limits<double>::quiet_NaN();
  /// Relative growth of Hc on a domain twice as large; NaN where a rough bound said that it does not matter.
  double domain_error_Hc = std::numeric_limits<double>::quiet_NaN();
  Verification verification;               ///< of the final state
  std::optional<adjoint::Errors> adjoint;  ///< of the final state, where they were asked for and found
  ErrorBars error_bars;                    ///< of the final state
  AccuracyReport accuracy;                 ///< where an accuracy was asked for
};

}  // namespace ehl::steady
