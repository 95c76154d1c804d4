#pragma once
// What is written down and told while solutions are made.
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fmg/hierarchy.hpp"
#include "judgement/measures.hpp"
#include "judgement/verification.hpp"

namespace ehl::fmg {

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
  double P_rim = 0.0;       ///< over those on the rim (judgement/measures.hpp)
  double residual = 0.0;    ///< relative residual of the Reynolds equation (root mean square over the wedge's)
  double load_error = 0.0;  ///< |h^2 sum P - load| / load, load 2 pi/3 of a circle
  int cycles = 0;
  double work_units = 0.0;  ///< in residual + deformation evaluations on this level
  double seconds = 0.0;

  /// False where the equation is missed by as much as its terms are worth, as where a coarse grid finds no way to a
  /// meniscus: the films of such a state tell nothing of the error of finer grids.
  bool solved() const { return residual < 0.5; }
};

/// Of the rows that are solved, and of the last one.
std::vector<double> column(const std::vector<LevelRow>& rows, double LevelRow::*value);

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

/// Called after every cycle: progress for a person, and the moment at which a stop is possible.
/// Returns false when the user asked to stop; the solver then throws core::Interrupted.
struct Progress {
  int level = 0;       ///< level being solved
  int levels = 0;      ///< levels in all
  int cycle = 0;       ///< cycle on this level, from 1
  int cycles = 0;      ///< cycles planned on this level
  int nx = 0, ny = 0;  ///< cells of the level
  double residual = 0.0;
  double Hc = 0.0;
  double fraction = 0.0;    ///< of the expected whole work, 0..1
  double load_ratio = 1.0;  ///< load being solved for, over the scene's: a load continuation
};
using ProgressCallback = std::function<bool(const Progress&)>;
/// For work that is a part of the whole, from one fraction of it to another; none for none.
ProgressCallback part_of(const ProgressCallback& whole, double from, double to);

/// What is known of the solutions so far. The last row of `levels` is of the level being solved.
struct Record {
  std::vector<LevelRow> levels{};  ///< coarse to fine
  std::vector<CycleRow> history{};
  judgement::Verification verification{};  ///< of the state that was looked at last
  // Of the finest level:
  bool converged = false;
  std::string failed_check{};  ///< empty when converged: else which level, which check, what to try
  CyclesEnd end = CyclesEnd::content;
  double cycle_factor = std::numeric_limits<double>::quiet_NaN();  ///< see steady::Solution
};

struct Run;

/// Counts work units from here on.
void forget_work(Hierarchy& hierarchy);
/// Enters the measures of a level, as after this many cycles, in the record.
void enter(const Hierarchy& hierarchy, std::size_t l, int cycle, const judgement::Measures& now, Record& record);
/// Tells the progress of a level, for the problem's load or a share of it. errors: core::Interrupted where the answer
/// is to stop.
void report(const Run& run, std::size_t l, int cycle, int planned, const judgement::Measures& now,
            double load_ratio = 1.0);
/// "level 3 (128 x 128 cells)".
std::string name_of_level(const Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::fmg
