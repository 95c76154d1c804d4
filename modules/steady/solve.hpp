#pragma once
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

using multigrid::Progress;
using multigrid::ProgressCallback;

/// Solves the steady contact problem (eqs. 1-3), or several passes of it, by full multigrid and, if that fails, by the
/// other strategies of modules/steady/README.md. in: a complete scene. out: the best state that was found, converged or
/// not.
/// errors: core::InputError (grid), core::SolverError (no strategy led to a finite state), core::Interrupted.
Solution solve(const Scene& scene, const ProgressCallback& progress = {});

}  // namespace ehl::steady
