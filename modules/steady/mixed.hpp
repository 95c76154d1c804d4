#pragma once
// Mixed lubrication: surfaces that touch at a boundary film.
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// Solves a scene with a boundary film. If its film without contact stays above the boundary film, that solution is the
/// result, to the bit. Else nested iteration with Newton's method. The first grid starts from the solution without
/// contact, if that exists, or from the dry contact under a thick boundary film, which is then reduced step by step
/// (continuation).
/// out: the best state that was found, converged or not; P is the sum of both pressures, P_f and P_c its parts.
/// errors: core::SolverError if no grid was solved; core::InputError (grid); core::Interrupted.
Solution solve_mixed(const Scene& scene, const ProgressCallback& progress);

/// Solves a scene with half its boundary film on half as many cells, which shows how much the contact depends on the
/// film. limits: even numbers of cells. errors: as of solve_mixed().
Solution solve_with_half_film(const Scene& scene);

}  // namespace ehl::steady
