#pragma once
// The results of a steady computation.
#include <optional>
#include <string>
#include <vector>

#include "adjoint/errors.hpp"
#include "core/constants.hpp"
#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/timer.hpp"
#include "core/warning.hpp"
#include "multigrid/record.hpp"
#include "newton/solve.hpp"
#include "reynolds/flow_balance.hpp"
#include "steady/error_bars.hpp"
#include "steady/starvation.hpp"

namespace ehl::steady {

using judgement::Verification;
using multigrid::CycleRow;
using multigrid::CyclesEnd;
using multigrid::LevelRow;

/// One strategy that was tried.
struct Attempt {
  std::string method;  ///< e.g. "full multigrid", "load continuation"
  std::string reason;  ///< why it failed; empty if it led to a solution
  double seconds = 0.0;
  std::string path{};  ///< the method as a code: "full-multigrid-2" (from the second start), "load-continuation"
};

/// One step of a load continuation, the rejected ones included.
struct ContinuationStep {
  double M = 0.0;
  double load_ratio = 1.0;    ///< over the load of the scene
  double Hc = core::unknown;  ///< NaN: its first cycle diverged
  double Hm = core::unknown;
  double residual = core::unknown;
  int cycles = 0;
  bool converged = false;
};

/// The outcome of a required accuracy.
struct AccuracyReport {
  double asked = core::unknown;  ///< NaN: none
  bool met = false;
  bool by_extrapolation = false;  ///< met by the extrapolated values, not by the nodal ones
  std::string stopped_by;         ///< the limit that prevented it; empty if met
  bool interrupted = false;       ///< by the user: the solution is that of the finest grid solved so far
};

/// A solution, and the record of the grid sequence that led to it.
struct Solution : multigrid::Record {
  core::Grid grid;
  core::Field P;
  core::Field H;
  double H00 = 0.0;
  core::Field P_f, P_c;                     ///< parts of P, of the fluid and of touching surfaces; empty: P is P_f
  core::Field Q;                            ///< oil content per area, if the scene has a supply; else empty
  core::Field theta;                        ///< Q/(rho_bar H)
  reynolds::OilBalance oil;                 ///< in, out and aside, if the scene has a supply
  double C_centre = 1.0;                    ///< the flow at (0, 0) is rho_bar H C: 1 without heat
  int chattering_nodes = 0;                 ///< number of chattering nodes
  std::optional<Starvation> starvation;     ///< if the scene has a supply
  std::vector<Pass> passes;                 ///< if the scene asks for several; all else is of the last one
  std::vector<std::vector<double>> tracks;  ///< layer left by each pass, per line of the domain; in units of H
  core::PartTimes times;
  std::string deformation;  ///< the method that evaluated the film, for the report
  core::Warnings warnings;
  double seconds = 0.0;
  std::string method;         ///< the strategy that led to this result
  std::string path = "none";  ///< the same as a code for scripts and plots (Attempt::path)
  std::vector<Attempt> attempts;
  std::vector<std::string> remedies;  ///< what slow cycles of this result needed, by the names in cycle_control.cpp
  std::vector<ContinuationStep> continuation;
  std::vector<newton::Step> newton;  ///< on the finest grid
  std::string polish_failure;        ///< why the Newton refinement did not reach rounding errors
  /// Relative growth of Hc on a domain twice as large; NaN if a rough bound showed that it does not matter.
  double domain_error_Hc = core::unknown;
  std::optional<adjoint::Errors> adjoint;  ///< of the final state, if requested and found
  ErrorBars error_bars;                    ///< of the final state
  AccuracyReport accuracy;                 ///< if an accuracy was requested
};

/// The pressure of the fluid alone.
inline const core::Field& fluid_pressure(const Solution& solution) {
  return solution.P_f.nodes_x() > 0 ? solution.P_f : solution.P;
}

}  // namespace ehl::steady
