#pragma once
#include <limits>
#include <optional>

namespace ehl::fmg {

enum class Cycle { V, W, F };
enum class LineSolver { elimination, decimation };

/// The hybrid line relaxation. The numbers are the same for every load; modules/fmg/README.md tells how they were
/// found.
struct RelaxationParameters {
  LineSolver line_solver = LineSolver::elimination;  ///< the faster one as measured (modules/line_solvers/README.md)
  int reach = 1;  ///< neighbours on each side in the truncated film equation: 1 is the paper's three terms
  /// Of a line contact: the distance at which single changes move the film no more. The logarithm leaves open where it
  /// is zero, and the load of a change is taken from somewhere.
  double line_zero = 1.0;
  double crossover = 1.5;             ///< of epsilon/h^2, above which a point is relaxed by Gauss-Seidel
  double least_single_epsilon = 0.0;  ///< and epsilon is above this, however fine the grid
  double weight_distributed = 0.9;    ///< under-relaxation of distributed changes
  double weight_single = 1.0;         ///< of single changes where epsilon is smooth
  double weight_single_steep = 0.5;   ///< of single changes where epsilon falls or rises by orders from cell to cell
  /// One relaxation changes a pressure by no more, p over p_h: it holds epsilon, or takes it to be linear, and knows
  /// nothing of it where the viscosity is another one by orders.
  double most_change = std::numeric_limits<double>::infinity();
  /// On square cells single changes are made along Y too (across_relaxation.hpp), by a film renewed before, which
  /// doubles the price. At 45 degrees cycles leave 0.60 to 0.70 of (1000, 15) at R_x/R_y = 5 and 20, (20, 15) and
  /// (100, 5) at 100, (1000, 5) at 50, and 0.21 to 0.42 with it. By the old film (20, 10) at 20 goes from 0.12 to 0.58:
  /// to a spike that is as much as the flow. On stretched cells they are made anyhow, by the old film: with a new one
  /// (1000, 15) at 20 goes from 0.54 to 0.50, (20, 15) at 50 from 0.42 to 0.48, at 100 from 0.58 to 0.65.
  bool across = false;
  /// Then lines along X take this times weight_single_steep, on square cells with epsilon at half points.
  double steep_before_across = 1.0;
  /// And this share of all their weights on coarse grids, with epsilon at the nodes.
  double coarse_before_across = 1.0;
  /// In an implicit step of time: what the single changes around a point squeeze out of its film beside what its own
  /// does. A relaxation of single points sees but its own, and a zone of them swings and diverges; how much there is
  /// is measured, not derived (modules/transient/README.md).
  double far_squeeze = 2.0;          ///< times its own, where a point changes singly for its epsilon
  double far_squeeze_beside = 0.2;   ///< H per P, where it does because it is beside the cavitated region
  double far_squeeze_of_zone = 0.0;  ///< H per P, of a line, where it does for its epsilon, on any cells
};

/// The same with this share of every weight.
inline RelaxationParameters lighter(RelaxationParameters how, double share) {
  how.weight_distributed *= share;
  how.weight_single *= share;
  how.weight_single_steep *= share;
  return how;
}

/// How the full multigrid works. The defaults need no tuning.
struct Parameters {
  std::optional<Cycle> cycle;  ///< absent: W; the steady solver has its own choice (steady/cycle_choice.hpp)
  std::optional<int> pre;      ///< nu_1, relaxations before the coarse grid correction; absent: 2, likewise
  std::optional<int> post;     ///< nu_2, relaxations after it; absent: 1, likewise
  int cycles = 2;              ///< cycles per level on the way up, at least
  int extra_cycles = 3;        ///< more of them on a level below the finest at most, where the checks ask for them
  int max_cycles = 60;         ///< on the finest grid, likewise
  /// Relative residual to reach on the finest grid; NaN: the level of the discretization error.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
  int coarsest_cells = 0;         ///< cells along x of the coarsest grid; 0: chosen
  int least_coarsest_cells = 32;  ///< where it is chosen
  int coarsest_sweeps = 10;      ///< relaxations at least on each visit of the coarsest grid, each followed by eq. (26)
  double load_relaxation = 0.1;  ///< c of eq. (26)
  int settling_sweeps = 2;       ///< relaxations of an interpolated solution, with epsilon by the mean of the nodes
  double settling_weight = 1.0;  ///< share of the weights in them
  bool lead_inward = false;      ///< of a point contact too: behind a cycle the inside follows the boundary
  RelaxationParameters relaxation;
};

}  // namespace ehl::fmg
