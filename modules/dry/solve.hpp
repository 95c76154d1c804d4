#pragma once
// The contact without lubricant: elastic bodies that touch and cannot overlap.
//
//   H(X,Y) = H00 + G(X,Y) + (K*P)(X,Y),   P >= 0, H >= 0, P H = 0,   hx hy sum P = load
//
// the same K*P as the film equation (6), with G = X^2/2 + Y^2/2 for two smooth balls, plus what the surfaces carry.
#include <functional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::dry {

struct Parameters {
  double tolerance = 1e-8;   ///< largest |H| where P > 0 and largest overlap where P = 0 [a^2/R]
  int max_iterations = 500;  ///< on each grid
  int coarsest_cells = 0;    ///< along x; 0: as long as 32 are left
};

struct Problem {
  core::Patch grid;  ///< the finest; the lower half where G is even in Y
  core::Field gap;   ///< G on its nodes
  double load = 0.0;
  mlmi::Parameters deformation{};
  Parameters parameters{};
  int threads = 1;
  double elastic = mlmi::circular_factor;      ///< factor of K*P
  core::QuadraticForm outline{1.0, 0.0, 1.0};  ///< 1 along the edge of a smooth contact: the first guess
};

/// G = X^2/2 + Y^2/2.
core::Field smooth_gap(const core::Patch& grid);

/// One row per grid, coarse to fine.
struct GridRow {
  int nx = 0;  ///< cells of the whole domain
  int ny = 0;
  double P_max = 0.0;
  double H00 = 0.0;
  double area = 0.0;   ///< of the nodes with P > 0 [a^2]
  double error = 0.0;  ///< what the tolerance is held against
  int iterations = 0;
  double seconds = 0.0;
};

/// Fields on the whole domain.
struct Solution {
  core::Grid grid;
  core::Field P;
  core::Field H;
  double H00 = 0.0;
  bool converged = false;
  std::string failed_check;  ///< empty when converged: which grid, which check, what to try
  std::vector<GridRow> rows;
  double load_error = 0.0;  ///< relative
  std::string deformation;  ///< what evaluated K*P
  double seconds = 0.0;
};

/// Told after every iteration.
struct Progress {
  core::Grid grid;
  int grids_left = 0;  ///< finer ones, still to come
  int iteration = 0;
  double error = 0.0;
};
/// Returns false when the user asked to stop; the solver then throws core::Interrupted.
using Observer = std::function<bool(const Progress&)>;

/// Solves the contact by conjugate gradients with projection, on one grid after another from the coarsest up.
/// order: 1.5 or better in the mesh size for a smooth contact (README.md). cost: two evaluations of K*P per iteration,
/// about 13 on 32 cells and 12 more with every halving of the mesh, coarser grids first.
/// source: Polonsky and Keer 1999, with the load kept by scaling.
/// errors: core::InputError when the evaluator of K*P refuses the grid; core::SolverError when a number is not finite;
/// core::Interrupted.
Solution solve(const Problem& problem, const Observer& observe = {});

}  // namespace ehl::dry
