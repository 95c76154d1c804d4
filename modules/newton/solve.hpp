#pragma once
// The steady problem on one grid by Newton's method: rescue where cycles fail, polish to rounding, and an independent
// certificate of what the cycles give.
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "fmg/hierarchy.hpp"

namespace ehl::newton {

struct Parameters {
  double tolerance = 1e-11;  ///< on the relative residual and on the relative load error
  /// Of a state that further steps do not better, rounding having the last word: what is taken for converged as well.
  double tolerance_of_rounding = 1e-11;
  int max_steps = 60;
  double longest_change = 0.3;  ///< of any pressure in one step, in units of p_h
};

struct Step {
  double residual = 0.0;  ///< relative, after the step
  int linear_iterations = 0;
};

struct Result {
  bool converged = false;
  /// Residual and load error are within the tolerance; converged asks for a positive film as well. A grid too coarse
  /// for the film meets its equations with a negative one: no solution, but a good start for the next finer grid.
  bool equations_met = false;
  std::string reason;  ///< why it stopped, with numbers; empty when converged
  std::vector<Step> steps;
};

/// Longest change of H00 in one step, by the film at the centre.
double longest_shift(double Hc);

/// Called after every step; false: the user asked to stop.
using Progress = std::function<bool(const Step&)>;

/// Solves eqs. (4)-(7) with P >= 0 on levels[l] by semismooth Newton steps for (P, H00), each linear system by flexible
/// GMRES with exact Jacobian products and one sparse LU (equations, preconditioner, gmres).
/// in: P of levels[l] and H00, as a finest level has them. out: P, film, coefficients, residual and H00 of the last
/// state, or on failure of the best one met. Converged only with residual and load error within the tolerance and a
/// film that is positive everywhere; with a far field in closed form, with it as it follows from that film.
/// limits: a start that carries pressure (Hertz will do) and a grid that holds the contact. From the Hertz pressure the
/// number of steps grows with the number of cells; from a coarser grid's solution it does not.
/// order: quadratic once the cavitated nodes are found. cost, memory: README.md.
/// threads: the same bits for any number. errors: core::InputError when the problem has no load to carry or no
/// cavitation; core::Interrupted; core::SolverError where the far field has no pressure on the boundary.
Result solve(fmg::Hierarchy& hierarchy, std::size_t l, const Parameters& parameters = {},
             const Progress& progress = {});

}  // namespace ehl::newton
