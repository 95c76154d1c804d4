#pragma once
#include <functional>

#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

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

/// Solves the steady contact problem (eqs. 1-3) by full multigrid. errors: core::InputError (grid), core::SolverError
/// (non-finite values), core::Interrupted.
Solution solve(const Scene& scene, const ProgressCallback& progress = {});

}  // namespace ehl::steady
