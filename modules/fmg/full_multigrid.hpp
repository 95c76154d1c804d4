#pragma once
// The full multigrid: from a first solution on a coarse grid to the finest.
#include "core/timer.hpp"
#include "fmg/cycles.hpp"
#include "fmg/hierarchy.hpp"
#include "fmg/record.hpp"

namespace ehl::fmg {

/// How the full multigrid begins.
struct Plan {
  std::size_t first = 0;  ///< level of the first grid
  double H00 = 0.0;       ///< to begin with
  int sweeps = 20;        ///< relaxations of the first grid alone, from the Hertz pressure
  int cycles = 4;         ///< cycles on the first grid, at least
  Caution at_first{};     ///< on the first grid
  Caution above{};        ///< and on the finer ones, to begin with
};

/// A full multigrid under way: the grids and their state, and what is known of the solution.
struct Run {
  Hierarchy hierarchy;
  Plan plan{};
  ProgressCallback progress{};
  Caution caution{};  ///< that was needed so far
  Record record{};

  std::size_t finest() const { return hierarchy.levels.size() - 1; }
};

/// Times a row of the record, and counts work units anew.
class RowTimer {
 public:
  explicit RowTimer(Run& run) : run_(run), began_(core::now()) { forget_work(run.hierarchy); }
  /// Enters the seconds since its birth in the last row.
  void stop() { run_.record.levels.back().seconds = core::now() - began_; }

 private:
  Run& run_;
  double began_;
};

/// The first grid from the Hertz pressure, every finer one from the one below it; cycles on each until its stopping
/// criterion is met. The first grid: until its film has settled. The finest: until all checks are met, or the
/// tolerance, with max_cycles at most. The others: parameters.cycles, and up to extra_cycles more where Hc or Hm ask
/// for them; beside a meniscus on all of those, until the residual too is low. errors: core::SolverError where the
/// cycles diverge; core::Interrupted.
void full_multigrid(Run& run);
/// The levels above `from`, whose solution is there.
void ascend(Run& run, std::size_t from);
/// Cycles on level l from the state that is there, until the criterion of its place in the hierarchy is met, with a new
/// row in the record.
void solve_level(Run& run, std::size_t l);

}  // namespace ehl::fmg
