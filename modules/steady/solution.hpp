#pragma once
// What a steady computation gives back.
#include <limits>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/timer.hpp"
#include "newton/solve.hpp"
#include "steady/error_bars.hpp"
#include "steady/verification.hpp"

namespace ehl::steady {

/// One row per grid level as the full multigrid goes up: what accuracy costs in time.
struct LevelRow {
  int level = 0;
  int nx = 0;  ///< cells
  int ny = 0;
  double Hc = 0.0;        ///< H at (0,0)
  double Hm = 0.0;        ///< minimum of H over the nodes
  double error_Hc = 0.0;  ///< relative discretization error, estimated; NaN where the sequence is too short
  double error_Hm = 0.0;
  double order_Hc = 0.0;    ///< observed order; NaN where unknown
  double Hm_fitted = 0.0;   ///< minimum of H between the nodes (fitted_minimum.hpp)
  double P_max = 0.0;       ///< over the nodes
  double residual = 0.0;    ///< relative residual of the Reynolds equation (root mean square over the wedge's)
  double load_error = 0.0;  ///< |h^2 sum P - load| / load, load 2 pi/3 of a circle
  int cycles = 0;
  double work_units = 0.0;  ///< in residual + deformation evaluations on this level
  double seconds = 0.0;
};

/// How a series of cycles ended.
enum class CyclesEnd {
  content,      ///< the checks had nothing against the state
  limit,        ///< no more cycles were allowed; the residual was still falling
  stalled,      ///< the residual no longer fell
  diverged,     ///< no finite state came out, with any caution
  no_solution,  ///< the equations are solved, by a state that is none of the contact: the mesh is too coarse
};

/// One row per cycle on any level.
struct CycleRow {
  int level = 0;
  int cycle = 0;
  double residual = 0.0;
  double load_error = 0.0;
  double Hc = 0.0;
  double Hm = 0.0;
};

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
  double Hc = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the cycles of the step diverged
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
};

struct Solution {
  core::Grid grid;
  core::Field P;
  core::Field H;
  double H00 = 0.0;
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
  Verification verification;  ///< of the final state
  ErrorBars error_bars;       ///< of the final state
  AccuracyReport accuracy;    ///< where an accuracy was asked for
};

}  // namespace ehl::steady
