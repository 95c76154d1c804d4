#pragma once
// A full multigrid solution of a scene.
#include "fmg/full_multigrid.hpp"
#include "steady/cycle_choice.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// True where so many cells, for a circular contact, hold the contact: begun on them the cycles find the film.
bool held_by(int cells, const Scene& scene);

/// The bodies of a scene as the multigrid needs them.
fmg::Geometry geometry_of(const contact::Ellipse& shape);
/// H00 to begin with: that of the dry contact and the film to expect.
double first_H00(const Scene& scene);

/// True where one half of the scene's grid is computed: it is symmetric in Y, and halving keeps all its levels.
bool on_one_half(const Scene& scene);

/// Makes the grids. errors: core::InputError.
fmg::Run begin_climb(const Scene& scene, const Start& start, const ProgressCallback& progress);

/// Newton's method behind the cycles where the scene asks for it; then the solution, converged or not.
/// errors: core::Interrupted.
Solution end_climb(const Scene& scene, fmg::Run&& run);
/// The solution, converged or not, that a run holds; with the errors by their weights where the scene asks for them.
Solution solution_of(const Scene& scene, fmg::Run&& run);

/// All of it, full multigrid in between. errors: core::SolverError where the cycles diverge; and as above.
Solution climb(const Scene& scene, const Start& start, const ProgressCallback& progress);

}  // namespace ehl::steady
