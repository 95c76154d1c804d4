#pragma once
// The dry contact: elastic bodies that touch and cannot overlap.
//
//   H(X,Y) = H00 + G(X,Y) + (K*P)(X,Y),   P >= 0, H >= 0, P H = 0,   hx hy sum P = load
//
// K*P is that of the film equation (6). G = X^2/2 + Y^2/2 for two smooth balls, plus the shape of the surfaces.
#include <functional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"
#include "core/quadratic_form.hpp"
#include "kernel/kernel.hpp"
#include "mlmi/deformation.hpp"

namespace ehl::dry {

/// Tolerance, iteration limit and coarsest grid of the solver.
struct Parameters {
  double tolerance = 1e-8;   ///< largest |H| where P > 0 and largest overlap where P = 0 [a^2/R]
  int max_iterations = 500;  ///< on each grid
  int coarsest_cells = 0;    ///< along x; 0: coarsen while at least 32 cells remain
};

/// A dry contact on a grid.
struct Problem {
  core::Patch grid;  ///< the finest grid; half of the domain if G is even in Y
  core::Field gap;   ///< G at its nodes
  double load = 0.0;
  mlmi::Parameters deformation{};
  Parameters parameters{};
  int threads = 1;
  kernel::Kernel kernel{};                     ///< of the deformation, K*P
  core::QuadraticForm outline{1.0, 0.0, 1.0};  ///< 1 along the edge of a smooth contact; gives the initial guess
};

/// G = X^2/2 + Y^2/2.
core::Field smooth_gap(const core::Patch& grid);
/// A ball with Hertz' load, 2 pi/3, and G = X^2/2 + Y^2/2 + S. in: surface: writes S; empty: smooth.
Problem ball_on_flat(const core::Patch& grid, const std::function<void(const core::Patch&, core::Field& S)>& surface);

/// One row per grid, coarse to fine.
struct GridRow {
  int nx = 0;  ///< cells of the whole domain
  int ny = 0;
  double P_max = 0.0;
  double H00 = 0.0;
  double area = 0.0;   ///< of the nodes with P > 0 [a^2]
  double error = 0.0;  ///< compared with the tolerance
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
  std::string failed_check;  ///< empty if converged; else grid, check and advice
  std::vector<GridRow> rows;
  double load_error = 0.0;  ///< relative
  std::string deformation;  ///< method that evaluated K*P
  double seconds = 0.0;
};

/// State after an iteration.
struct Progress {
  core::Grid grid;
  int grids_left = 0;  ///< finer grids still to come
  int iteration = 0;
  double error = 0.0;
};
/// Called after every iteration. Returns false if the user asked to stop; the solver then throws core::Interrupted.
using Observer = std::function<bool(const Progress&)>;

/// Solves the contact by conjugate gradients with projection, on one grid after another from the coarsest to the
/// finest.
/// order: 1.5 or better in the mesh size for a smooth contact. cost: two evaluations of K*P per iteration; the number
/// of iterations grows by about a constant with each finer grid.
/// limits: waves on a surface need about eight cells per wave length. [bench: dry_cells_per_wave]
/// source: Polonsky and Keer 1999, with the load maintained by scaling.
/// errors: core::InputError if the evaluator of K*P refuses the grid; core::SolverError if a number is not finite;
/// core::Interrupted.
Solution solve(const Problem& problem, const Observer& observe = {});

}  // namespace ehl::dry
