#pragma once
#include <limits>
#include <optional>

#include "judgement/tuning.hpp"
#include "multigrid/tuning.hpp"

namespace ehl::multigrid {

enum class Cycle { V, W, F };
enum class LineSolver { elimination, decimation };

/// The hybrid line relaxation (modules/multigrid/README.md). The numbers are the same for every load.
struct RelaxationParameters {
  LineSolver line_solver = LineSolver::elimination;  ///< the faster one (modules/line_solvers/README.md)
  int reach = 1;  ///< neighbours on each side in the truncated film equation: 1 is the paper's three terms
  /// Line contacts: distance |X| at which a single change no longer moves the film. The logarithmic kernel leaves this
  /// distance open.
  double line_zero = 1.0;
  double crossover = 1.5;             ///< epsilon/h^2 above which a point is relaxed singly (Gauss-Seidel)
  double least_single_epsilon = 0.0;  ///< a single point also needs epsilon above this, however fine the grid
  double weight_distributed = 0.9;    ///< under-relaxation of distributed changes
  double weight_single = 1.0;         ///< under-relaxation of single changes where epsilon is smooth
  double weight_single_steep = 0.5;   ///< of single changes where epsilon varies by orders between cells
  /// Step limit: largest change of a pressure P in one relaxation. The relaxation holds epsilon, or takes it as linear
  /// in P, which is wrong where the change alters the viscosity by orders.
  double most_change = std::numeric_limits<double>::infinity();
  /// On square cells, too, a Y sweep relaxes the single points along Y (across_relaxation.hpp), with the film renewed
  /// before it, which doubles the cost. Stretched cells always have a Y sweep, with the film as it was before the X
  /// sweep. [bench: y_sweep]
  bool across = false;
  /// X sweep before a Y sweep, square cells, epsilon at half points: factor on weight_single_steep.
  double steep_before_across = 1.0;
  /// X sweep before a Y sweep, square cells, epsilon at the nodes (coarse grids): factor on all weights.
  double coarse_before_across = 1.0;
  /// Implicit time step: what the single changes around a point squeeze out of its film, in addition to its own change.
  /// A relaxation of single points takes its own change alone into account, and a zone of such points oscillates and
  /// diverges. The amounts are measured, not derived (modules/transient/README.md).
  double far_squeeze = 2.0;          ///< times its own, if the point is single because of its epsilon
  double far_squeeze_beside = 0.2;   ///< H per P, if it is single next to the cavitated region
  double far_squeeze_of_zone = 0.0;  ///< H per P, line contacts, if single because of its epsilon
};

/// These parameters with every under-relaxation weight multiplied by `share`.
inline RelaxationParameters lighter(RelaxationParameters how, double share) {
  how.weight_distributed *= share;
  how.weight_single *= share;
  how.weight_single_steep *= share;
  return how;
}

/// Parameters of the full multigrid solve. The defaults need no tuning.
struct Parameters {
  std::optional<Cycle> cycle;  ///< absent: W, or the steady solver's choice (steady/cycle_choice.hpp)
  std::optional<int> pre;      ///< nu_1, relaxations before the coarse grid correction; absent: 2, or as above
  std::optional<int> post;     ///< nu_2, relaxations after it; absent: 1, or as above
  int cycles = 2;              ///< least number of cycles per level
  int extra_cycles = 3;        ///< further cycles on a level below the finest, at most, if its checks ask for them
  int max_cycles = 60;         ///< largest number of cycles on the finest grid
  /// Relative residual to reach on the finest grid; NaN: the algebraic error falls below the discretization error.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
  int coarsest_cells = 0;         ///< cells along X of the coarsest grid; 0: chosen
  int least_coarsest_cells = 32;  ///< least number of them where the program chooses
  int coarsest_sweeps = 10;       ///< least number of relaxations per visit of the coarsest grid, each with eq. (26)
  double load_relaxation = 0.1;   ///< c of eq. (26)
  int settling_sweeps = 2;        ///< relaxations of an interpolated solution, with epsilon as the mean of the nodes
  double settling_weight = 1.0;   ///< factor on the weights in these relaxations
  /// Corrections are weighted by face conductances on every grid, not only where coarse_problem.hpp says so.
  bool weighted_corrections = false;
  bool extend_boundary = false;  ///< extend boundary changes into the domain after a cycle
  RelaxationParameters relaxation;
  Tuning tuning;
  judgement::Tuning judgement;
};

}  // namespace ehl::multigrid
