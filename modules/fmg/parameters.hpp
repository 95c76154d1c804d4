#pragma once
#include <limits>
namespace ehl::fmg {

enum class Cycle { V, W, F };

/// How the full multigrid works. The defaults need no tuning.
struct Parameters {
  Cycle cycle = Cycle::W;
  int pre = 2;              ///< nu_1, relaxations before the coarse grid correction
  int post = 1;             ///< nu_2, relaxations after it
  int cycles = 2;           ///< cycles per level on the way up
  int max_cycles = 60;      ///< on the finest grid, where a tolerance is set
  /// Relative residual to reach on the finest grid; NaN: only `cycles` cycles, then the checks.
  double tolerance = std::numeric_limits<double>::quiet_NaN();
  int coarsest_cells = 0;   ///< cells along x of the coarsest grid; 0: chosen
};

}  // namespace ehl::fmg
