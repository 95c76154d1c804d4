#pragma once
// One full multigrid solution of a scene.
#include "multigrid/full_multigrid.hpp"
#include "steady/cycle_choice.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// True if a first grid of so many cells (counted for a circular contact) resolves the film zones well enough for the
/// cycles to converge from it.
bool held_by(int cells, const Scene& scene);

/// The bodies of a scene in the form that the multigrid needs.
multigrid::Geometry geometry_of(const Scene& scene);
/// The closed far field around a domain. in: the load that deforms the bodies, in units of p_h a^2.
reynolds::FarField far_field(const Scene& scene, double load, const core::Grid& domain);
/// Mutual approach of the dry bodies, by the deformation of their centre under the Hertz pressure.
double dry_approach(const Scene& scene);
/// Initial H00: that of the dry contact plus the expected central film, or plus a tenth of it on stretched cells.
double first_H00(const Scene& scene);

/// True if only one half of the grid is computed: the scene is symmetric in Y, and the half grid can be coarsened as
/// often as the whole one.
bool on_one_half(const Scene& scene);

/// The numbers that the observer of the scene computes from the solution on a level; empty without an observer.
/// in: the factors of heat in the film on the whole domain, as in SolvedFilm; empty fields for a cold film.
std::vector<double> observed(const Scene& scene, const multigrid::Hierarchy& hierarchy, std::size_t l,
                             const core::Field& I0, const core::Field& less_tau);

/// Makes the grids and the plan of a full multigrid solve; computes nothing. errors: core::InputError.
multigrid::Run begin_multigrid(const Scene& scene, const Start& start, const ProgressCallback& progress);

/// Newton refinement after the cycles if the scene asks for it; then the solution, converged or not. errors:
/// core::Interrupted.
Solution end_multigrid(const Scene& scene, multigrid::Run&& run);
/// The solution that a run holds, converged or not, with adjoint error estimates if the scene asks for them.
Solution solution_of(const Scene& scene, multigrid::Run&& run);

/// A full multigrid solve from begin to end. errors: core::SolverError if the cycles diverge; and those of
/// begin_multigrid() and end_multigrid().
Solution solve_by_multigrid(const Scene& scene, const Start& start, const ProgressCallback& progress);

}  // namespace ehl::steady
