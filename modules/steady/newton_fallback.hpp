#pragma once
// Newton's method: the fallback if the cycles fail, and the refinement down to rounding errors if the scene asks for
// it.
#include "steady/multigrid_solve.hpp"

namespace ehl::steady {

/// Most nodes for which Newton's method is tried unasked; its sparse factors limit it. [bench: most_nodes_of_newton]
inline constexpr double most_nodes_of_newton = 3e5;
/// Most nodes for which it is tried a second time. [bench: most_nodes_of_second_newton]
inline constexpr double most_nodes_of_second_newton = 1e5;

/// Tolerance of Newton's method on the finest grid: rounding, or the scene's if that is smaller.
double final_tolerance(const Scene& scene);

/// Newton's method on level l from its present state, with reports of its progress.
newton::Result solve_level_by_newton(const Scene& scene, multigrid::Run& run, std::size_t l, double tolerance,
                                     int max_steps = newton::Parameters{}.max_steps);

/// Checks the state of the finest grid after Newton's method; its algebraic error is estimated from the residual, as
/// there is no last cycle. If Newton's method did not converge, the solution fails with this reason.
void judge_newton(const Scene& scene, multigrid::Run& run, bool newton_converged, const std::string& reason);

/// Newton refinement: Newton's method on the finest grid from the present state, down to rounding errors or to the
/// scene's tolerance if that is smaller; the last row of the level table then describes its state. If it fails, the
/// better of both states stays, and Solution::polish_failure says why.
/// errors: core::Interrupted.
Solution polished(const Scene& scene, multigrid::Run&& run);

/// Newton fallback: the finest grid by Newton's method from a state that the cycles did not solve, then the two grids
/// below it from its solution, for the error estimate.
/// in: unsolved, a solution of the scene that is not converged.
Solution refine_by_newton(const Scene& scene, const Start& start, const Solution& unsolved,
                          const ProgressCallback& progress);

/// Solves the finest grid alone by Newton's method, from the state of another solution, down to the scene's tolerance.
/// errors: core::Interrupted.
Solution follow_by_newton(const Scene& scene, const Start& start, const Solution& before,
                          const ProgressCallback& progress);

/// Nested iteration with Newton's method instead of cycles. Grids up to 128 cells start from the Hertz pressure if the
/// next coarser grid was not solved; all others start from the coarser solution.
/// errors: core::SolverError if no grid up to 128 cells was solved; core::Interrupted.
Solution solve_by_newton(const Scene& scene, const Start& start, const ProgressCallback& progress);

}  // namespace ehl::steady
