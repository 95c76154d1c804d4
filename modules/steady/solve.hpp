#pragma once
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

using fmg::Progress;
using fmg::ProgressCallback;

/// Solves the steady contact problem (eqs. 1-3) by full multigrid. errors: core::InputError (grid), core::SolverError
/// (non-finite values), core::Interrupted.
Solution solve(const Scene& scene, const ProgressCallback& progress = {});

}  // namespace ehl::steady
