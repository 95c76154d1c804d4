#pragma once
// A full multigrid solution: the climb from the first grid to the finest.
#include <cstddef>
#include <string>

#include "fmg/hierarchy.hpp"
#include "steady/cycles.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// How a climb begins, and how cautious it is.
struct Start {
  int cells = 64;                 ///< along x on the first grid, at least
  int sweeps = 20;                ///< relaxations of that grid alone, from the Hertz pressure
  int cycles = 4;                 ///< cycles on that grid, at least
  int coarsest = 32;              ///< cells along x of the coarsest grid of all cycles, at least
  int balances = 10;              ///< relaxations with force balance on the coarsest grid
  double caution_at_first = 1.0;  ///< factor on all under-relaxation weights on the first grid
  double caution = 1.0;           ///< and on the finer ones
  double coarseness = 0.0;        ///< the first grid's step, at most, over the one that resolves the film; 0: any
};

/// From this load on 64 cells do not hold the contact, nor 32 a correction for it.
inline constexpr double heavy_M = 1500.0;

/// A climb under way: the grids and their state, and what is known of the solution.
struct Climb {
  const Scene& scene;
  const ProgressCallback& progress;
  Start start;
  fmg::Hierarchy hierarchy;
  std::size_t first = 0;  ///< level of the first grid
  Caution caution{};
  Solution solution{};

  std::size_t finest() const { return hierarchy.levels.size() - 1; }
};

/// The bodies of a scene as the multigrid needs them.
fmg::Geometry geometry_of(const contact::Ellipse& shape);
/// H00 to begin with: that of the dry contact and the film to expect.
double first_H00(const Scene& scene);

/// True where one half of the scene's grid is computed: it is symmetric in Y, and halving keeps all its levels.
bool on_one_half(const Scene& scene);

/// Makes the grids. Cycles that the scene leaves open are F(2,0) to the level of the discretization error and W(2,1)
/// towards a tolerance. errors: core::InputError.
Climb begin_climb(const Scene& scene, const Start& start, const ProgressCallback& progress);

/// The first grid, from the Hertz pressure, until it is solved well enough to go on from.
/// errors: core::SolverError where the cycles diverge; core::Interrupted.
void solve_first_level(Climb& climb);
/// Cycles on level l from the state that is there: `planned` at least, then until the checks have nothing to say; on
/// the finest level against the tolerance and as many as that takes, below it a few more than planned at most. errors:
/// as above.
void solve_level(Climb& climb, std::size_t l, int planned);
/// The levels above `from`, each from the one below it; and the polish where the scene asks for it. errors: as above.
void ascend(Climb& climb, std::size_t from);
/// What a grid of the climb, mirrored or not, holds of a field on the whole domain.
core::Field part_on(const core::Grid& grid, core::Field field);
/// The other way: a field of a grid of the climb on the whole domain.
core::Field on_whole(const core::Grid& grid, core::Field field);
/// The solution, converged or not, out of the climb.
Solution result_of(Climb&& climb);

/// All of it.
Solution climb(const Scene& scene, const Start& start, const ProgressCallback& progress);

/// Counts work units from here on.
void forget_work(fmg::Hierarchy& hierarchy);
/// Enters the state of a level, as after this many cycles, in the table of levels.
void record(Climb& climb, std::size_t l, int cycle, const StateOfLevel& now);
/// Tells the progress of a level, for the scene's load or a share of it. errors: core::Interrupted where the answer is
/// to stop.
void report(const Climb& climb, std::size_t l, int cycle, int planned, const StateOfLevel& now,
            double load_ratio = 1.0);
/// "level 3 (128 x 128 cells)".
std::string name_of_level(const fmg::Hierarchy& hierarchy, std::size_t l);

}  // namespace ehl::steady
