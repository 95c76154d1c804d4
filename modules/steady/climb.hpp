#pragma once
// One full multigrid solution: the climb from the first grid to the finest.
#include "fmg/hierarchy.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// How a climb begins, and how cautious it is.
struct Start {
  int cells = 64;                 ///< along x on the first grid, at least
  int sweeps = 20;                ///< relaxations of that grid alone, from the Hertz pressure
  int cycles = 4;                 ///< cycles on that grid, at least
  int coarsest = 32;              ///< cells along x of the coarsest grid of all cycles, at least
  int balances = 10;              ///< relaxations with force balance on the coarsest grid
  double caution_at_first = 1.0;  ///< factor on all under-relaxation weights on the first grid
  double caution = 1.0;           ///< and on the finer ones
};

/// Climbs. out: the solution, converged or not. errors: core::SolverError where the cycles diverge, core::Interrupted.
Solution climb(const Scene& scene, const Start& start, const ProgressCallback& progress);

}  // namespace ehl::steady
