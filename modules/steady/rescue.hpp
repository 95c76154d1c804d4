#pragma once
// Newton's method where the cycles do not lead to a solution, and after them where rounding errors are asked for.
#include "steady/climb.hpp"

namespace ehl::steady {

/// Nodes up to which Newton's method is tried unasked: its sparse factors take 0.6 GB and half a minute there.
inline constexpr double most_nodes_of_rescue = 3e5;
/// Nodes up to which it is tried a second time: on 513^2 a step takes 2 to 5 s, and many that lead nowhere minutes.
inline constexpr double most_nodes_of_two_rescues = 1e5;

/// Newton's method on the finest grid, from the state that is there, down to rounding errors or the scene's tolerance
/// where that is smaller; the last row of the level table then tells of its state. Where it fails the better of both
/// states stays, and Solution::polish_failure says why.
/// errors: core::Interrupted.
Solution polished(const Scene& scene, fmg::Run&& run);

/// The finest grid by Newton's method from a state that cycles have left unsolved; then the two grids below it from its
/// solution, for the estimate of its error.
/// in: unsolved, a solution of the scene that is not converged.
Solution rescue_by_newton(const Scene& scene, const Start& start, const Solution& unsolved,
                          const ProgressCallback& progress);

/// The finest grid alone by Newton's method from the state of another solution, down to the scene's tolerance.
/// errors: core::Interrupted.
Solution follow_by_newton(const Scene& scene, const Start& start, const Solution& before,
                          const ProgressCallback& progress);

/// The way up with Newton's method on every grid instead of cycles: from the Hertz pressure on the first grid, and on
/// those up to 128 cells whose coarser grid was not solved; from the coarser grid's solution else.
/// errors: core::SolverError where no grid up to 128 cells was solved; core::Interrupted.
Solution climb_by_newton(const Scene& scene, const Start& start, const ProgressCallback& progress);

}  // namespace ehl::steady
