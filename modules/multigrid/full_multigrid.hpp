#pragma once
// The full multigrid solve: from a first solution on a coarse grid to the finest grid.
#include <functional>
#include <string>
#include <vector>

#include "core/timer.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/hierarchy.hpp"
#include "multigrid/record.hpp"

namespace ehl::multigrid {

/// How the full multigrid begins.
struct Plan {
  std::size_t first = 0;  ///< level of the first grid
  double H00 = 0.0;       ///< initial value
  int sweeps = 20;        ///< relaxations of the Hertz pressure on the first grid, before any cycle
  int cycles = 4;         ///< least number of cycles on the first grid
  Damping at_first{};     ///< damping on the first grid
  Damping above{};        ///< initial damping on the finer grids
};

/// Computes numbers from the solution on a level. Each number gets an error bar from its values on all levels. The
/// observer changes nothing and is called once for each solved level.
using LevelObserver = std::function<std::vector<double>(const Hierarchy& hierarchy, std::size_t l)>;

/// A full multigrid solve in progress: the grids with their state, and what is known of the solution.
struct Run {
  Hierarchy hierarchy;
  Plan plan{};
  ProgressCallback progress{};
  LevelObserver observer{};  ///< may be empty
  Damping damping{};         ///< damping that was needed so far
  Record record{};
  State two_below{};  ///< solution two levels below the next one; empty: not to be used for extrapolation
  std::vector<std::string> remedies{};  ///< what the cycles of all levels needed (CyclesResult::remedies)

  std::size_t finest() const { return hierarchy.levels.size() - 1; }
};

/// Times one row of the record and restarts the count of work units.
class RowTimer {
 public:
  explicit RowTimer(Run& run) : run_(run), began_(core::now()) { forget_work(run.hierarchy); }
  /// Enters the seconds since construction in the last row, if there is one.
  void stop() {
    if (!run_.record.levels.empty()) run_.record.levels.back().seconds = core::now() - began_;
  }

 private:
  Run& run_;
  double began_;
};

/// Work on one level of a run.
using LevelStep = std::function<void(Run& run, std::size_t l)>;
/// The loop over the levels from `from` to below `end`: `begin` makes the initial state of a level; `solve` solves it
/// and adds its row to the record, which is timed.
void for_levels(Run& run, std::size_t from, std::size_t end, const LevelStep& begin, const LevelStep& solve);

/// A `begin`: from the solution on the level below; extrapolated from two levels below if the loop has solved both.
void start_from_below(Run& run, std::size_t l);

/// A `solve`: cycles on level l from its present state until its stopping criterion holds; adds a row to the record.
/// - first grid: its film has settled;
/// - finest grid: all checks are met, or the tolerance; max_cycles at most;
/// - other grids: parameters.cycles, and up to extra_cycles more if Hc or Hm need them;
/// - mass-conserving cavitation model, all grids below the finest: in addition the residual must be low, with more
///   cycles allowed.
/// errors: core::SolverError if the cycles diverge; core::Interrupted.
void solve_level(Run& run, std::size_t l);

/// The full multigrid solve: the first grid from the Hertz pressure, every finer one from the solutions below it.
/// errors: as solve_level().
void full_multigrid(Run& run);

}  // namespace ehl::multigrid
