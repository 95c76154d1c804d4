#pragma once
// Records and progress reports of a solve.
#include <functional>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "judgement/measures.hpp"
#include "judgement/verification.hpp"
#include "multigrid/hierarchy.hpp"

namespace ehl::multigrid {

/// One row per grid level of the full multigrid solve: its accuracy and its cost.
struct LevelRow {
  int level = 0;
  int nx = 0;  ///< cells
  int ny = 0;
  double Hc = 0.0;             ///< H at (0,0)
  double Hm = 0.0;             ///< minimum of H over the nodes
  double mesh_error_Hc = 0.0;  ///< relative discretization error, estimated; NaN where the sequence is too short
  double mesh_error_Hm = 0.0;
  double order_Hc = 0.0;           ///< observed order; NaN where unknown
  double Hm_fitted = 0.0;          ///< minimum of H between the nodes (fitted_minimum.hpp)
  double P_max = 0.0;              ///< over the nodes
  double P_rim = 0.0;              ///< over those on the rim (judgement/measures.hpp)
  std::vector<double> observed{};  ///< numbers that the observer of the run computed from the solution of the level
  double residual = 0.0;           ///< relative residual of the Reynolds equation (root mean square over the wedge's)
  double load_error = 0.0;         ///< |h^2 sum P - load| / load, load 2 pi/3 for a circular contact
  int cycles = 0;
  double work_units = 0.0;  ///< in evaluations of residual and deformation on this level
  double seconds = 0.0;

  /// False if the residual is as large as the terms of the equation, for example where a coarse grid does not find the
  /// meniscus. The films of such a state say nothing about the error of finer grids.
  bool solved() const { return residual < 0.5; }
};

/// One member of all rows that are solved, and of the last row.
std::vector<double> column(const std::vector<LevelRow>& rows, double LevelRow::*value);
/// An observed number of the same rows; rows without it are left out.
std::vector<double> column_observed(const std::vector<LevelRow>& rows, std::size_t number);

/// How a series of cycles ended.
enum class CyclesEnd {
  converged,    ///< all checks are met
  limit,        ///< no more cycles were allowed; the residual was still falling
  stalled,      ///< the residual no longer fell
  diverged,     ///< no finite state with any damping
  no_solution,  ///< the equations are solved by an unphysical state: the mesh is too coarse
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

/// Progress of a solve, passed to the callback after every cycle. The callback returns false when the user asked to
/// stop; the solver then throws core::Interrupted.
struct Progress {
  int level = 0;       ///< level being solved
  int levels = 0;      ///< levels in all
  int cycle = 0;       ///< cycle on this level, from 1
  int cycles = 0;      ///< cycles planned on this level
  int nx = 0, ny = 0;  ///< cells of the level
  double residual = 0.0;
  double Hc = 0.0;
  double fraction = 0.0;    ///< share of the expected work that is done, 0..1
  double load_ratio = 1.0;  ///< load being solved for, over the deck's (load continuation)
};
using ProgressCallback = std::function<bool(const Progress&)>;
/// Callback for a part of the work, from one fraction of the whole to another; empty if `whole` is.
ProgressCallback part_of(const ProgressCallback& whole, double from, double to);

/// What is known of the solutions so far. The last row of `levels` belongs to the level being solved.
struct Record {
  std::vector<LevelRow> levels{};  ///< coarse to fine
  std::vector<CycleRow> history{};
  judgement::Verification verification{};  ///< of the last state that was judged
  // The finest level alone:
  bool converged = false;
  std::string failed_check{};  ///< empty if converged; else the level, the check and what to try
  CyclesEnd end = CyclesEnd::converged;
  /// Convergence factor: geometric mean, over all cycles but the first, of the residual after a cycle over that before
  /// it; NaN with fewer than two cycles.
  double cycle_factor = core::unknown;
};

struct Run;

/// Restarts the count of work units.
void forget_work(Hierarchy& hierarchy);
/// Enters the measures of a level after `cycle` cycles in the record.
void enter(const Hierarchy& hierarchy, std::size_t l, int cycle, const judgement::Measures& now, Record& record);
/// Enters the numbers of the observer for the solution on level l in the last row of the record.
void observe(Run& run, std::size_t l);
/// Reports the progress of a level, at the problem's load or a share of it. errors: core::Interrupted if the callback
/// returns false.
void report(const Run& run, std::size_t l, int cycle, int planned, const judgement::Measures& now,
            double load_ratio = 1.0);
/// "level 3 (128 x 128 cells)".
std::string name_of_level(const Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::multigrid
