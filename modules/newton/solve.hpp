#pragma once
// Newton's method for the steady problem on one grid: fallback if the cycles fail, refinement down to rounding, and an
// independent check of the cycles' solution.
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "multigrid/hierarchy.hpp"
#include "newton/tuning.hpp"

namespace ehl::newton {

struct Parameters {
  double tolerance = 1e-11;  ///< on the relative residual and on the relative load error
  /// A state that further steps do not improve counts as converged if it is below this tolerance.
  double tolerance_of_rounding = 1e-11;
  int max_steps = 60;
  Tuning tuning;
};

struct Step {
  double residual = 0.0;  ///< relative, after the step
  int linear_iterations = 0;
};

struct Result {
  bool converged = false;
  /// Residual and load error are within the tolerance; `converged` also requires a positive film. A grid too coarse for
  /// the film may satisfy its equations with a negative one: no solution, but a good start for the next finer grid.
  bool equations_met = false;
  std::string reason;  ///< why the iteration stopped, with numbers; empty if converged
  std::vector<Step> steps;
};

/// Largest change of H00 in one step, from the film at the centre.
double longest_shift(double Hc);

/// Called after every step. out: false if the user asks to stop.
using Progress = std::function<bool(const Step&)>;

/// Solves eqs. (4)-(7) with P >= 0 on levels[l] by semismooth Newton steps for (P, H00). Each linear system is solved
/// by flexible GMRES with exact Jacobian products and one sparse LU (equations, preconditioner, gmres).
/// in: P of levels[l] and H00, as for a finest level. out: P, film, coefficients, residual and H00 of the last state,
/// or of the best state after a failure. Converged only if residual and load error are within the tolerance and the
/// film is positive everywhere; a far field in closed form is consistent with that film.
/// limits: the start must carry pressure (Hertz is enough), and the grid must resolve the contact. From the Hertz
/// pressure the number of steps grows with the number of cells; from a coarser grid's solution it does not.
/// order: quadratic once the cavitated nodes are found. cost, memory: README.md.
/// threads: the same bits for any number. errors: core::InputError if the problem has no load or no cavitation;
/// core::Interrupted; core::SolverError if the far field has no pressure on the boundary.
Result solve(multigrid::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters = {},
             const Progress& progress = {});

}  // namespace ehl::newton
