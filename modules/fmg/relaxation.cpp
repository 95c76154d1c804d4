#include "fmg/relaxation.hpp"

#include <cstdio>
#include <string>

#include "core/errors.hpp"
#include "fmg/line_batch.hpp"

namespace ehl::fmg {
namespace {

using core::LaneMask;
using core::Lanes;

// Applies the changes of one colour at station i to its own lines and to the lines between them:
// P_ij += delta_ij - (distributed_{i-1} + distributed_{i+1} + distributed_{j-1} + distributed_{j+1})/4 (eq. 15),
// and holds P >= 0.
void apply_changes(Level& level, int colour, bool cavitation, int i) {
  const int ny = level.grid.ny;
  const LineChanges& changes = level.changes;
  const double* delta = changes.delta.at_x(i);
  const double* here = changes.distributed.at_x(i);
  const double* west = changes.distributed.at_x(i - 1);
  const double* east = changes.distributed.at_x(i + 1);
  double* P = level.P.at_x(i);
  const auto floor = [cavitation](Lanes p) { return cavitation ? (p < 0.0 ? Lanes{} : p) : p; };
  Lanes south_edge{};  // the distributed change of the line before the batch
  for (int batch = 0; first_line(colour, batch) - 1 < ny; ++batch) {
    const int j = first_line(colour, batch);
    const int k = batch * core::lanes;
    const Lanes low = core::load(P + j - 1);
    const Lanes high = core::load(P + j + 7);
    // Behind the last line may stand what the other colour left there.
    const Lanes own_lines = inside(j, ny) ? core::load(here + k) : Lanes{};
    const Lanes one_south = __builtin_shuffle(south_edge, own_lines, LaneMask{7, 8, 9, 10, 11, 12, 13, 14});
    south_edge = own_lines;
    Lanes between = floor(core::evens(low, high) - 0.25 * (one_south + own_lines));
    Lanes own =
        floor(core::odds(low, high) + core::load(delta + k) - 0.25 * (core::load(west + k) + core::load(east + k)));
    between = inside(j - 1, ny) ? between : core::evens(low, high);
    own = inside(j, ny) ? own : core::odds(low, high);
    core::store(P + j - 1, core::interleaved_low(between, own));
    core::store(P + j + 7, core::interleaved_high(between, own));
  }
}

std::string describe(const line_solvers::SmallPivot& small, int line, const core::Grid& grid) {
  char text[160];
  std::snprintf(text, sizeof text,
                "line relaxation on %d x %d cells: pivot %.3g at point i = %d of line j = %d is nothing beside its row "
                "(the state has diverged)",
                grid.nx, grid.ny, small.pivot, small.point, line);
  return text;
}

template <int reach, LineSolver solver>
void relax_colour(Hierarchy& hierarchy, Level& level, int colour) {
  const int batches = batches_of_colour(level.grid, colour);
  const int threads = hierarchy.threads_on(level.grid);
  const bool cavitation = hierarchy.problem.cavitation;
  line_solvers::SmallPivot small;
  int small_line = 0;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    LineBatch<reach, solver> work(level.grid.nx);
#pragma omp for schedule(static)
    for (int batch = 0; batch < batches; ++batch) {
      const line_solvers::SmallPivot met = work.solve(hierarchy, level, colour, batch);
      if (met.point >= 0) {
        const int line = first_line(colour, batch) + 2 * met.lane;
#pragma omp critical
        if (small.point < 0 || line < small_line) {  // the first line, whichever thread met it
          small = met;
          small_line = line;
        }
      }
    }
#pragma omp for schedule(static)
    for (int i = 1; i < level.grid.nx; ++i) apply_changes(level, colour, cavitation, i);
  }
  if (small.point >= 0) throw core::SolverError(describe(small, small_line, level.grid));
}

template <int reach>
void relax_lines(Hierarchy& hierarchy, Level& level) {
  for (int colour = 0; colour < 2; ++colour) {
    if (hierarchy.parameters.relaxation.line_solver == LineSolver::elimination)
      relax_colour<reach, LineSolver::elimination>(hierarchy, level, colour);
    else
      relax_colour<reach, LineSolver::decimation>(hierarchy, level, colour);
  }
}

}  // namespace

void relax(Hierarchy& hierarchy, Level& level) {
  {
    const core::ScopedTimer timer(hierarchy.times, core::Part::line_solve);
    switch (hierarchy.parameters.relaxation.reach) {
      case 1: relax_lines<1>(hierarchy, level); break;
      case 2: relax_lines<2>(hierarchy, level); break;
      default: relax_lines<3>(hierarchy, level); break;
    }
  }
  update_film(hierarchy, level);
}

}  // namespace ehl::fmg
