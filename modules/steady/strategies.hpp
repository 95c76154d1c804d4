#pragma once
// The strategies for one scene, one after another.
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// The solution by the first strategy of the table (strategies.cpp) that succeeds; else the best state that was found.
/// in: flooded: the flooded solution of a starved line contact, or none.
/// errors: core::SolverError if no strategy led to a finite state; core::InputError (grid); core::Interrupted.
Solution solve_by_strategies(const Scene& scene, const ProgressCallback& progress, const Solution* flooded = nullptr);

}  // namespace ehl::steady
