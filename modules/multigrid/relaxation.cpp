#include "multigrid/relaxation.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "multigrid/across_relaxation.hpp"
#include "multigrid/line_batch.hpp"
#include "multigrid/line_relaxation.hpp"

namespace ehl::multigrid {
namespace {

using core::LaneMask;
using core::Lanes;

// Applies the changes of one batch in column i to its own lines and to the line before each of them:
// P_ij += delta_ij - (distributed_{i-1} + distributed_{i+1} + distributed_{j-1} + distributed_{j+1})/4 (eq. 15).
// For a line contact half of the two along X, on stretched cells DistributedShares replace the quarters. Then the
// pressure is projected on P >= 0 where the cavitation model demands it.
void apply_changes(Level& level, int colour, int batch, reynolds::Cavitation cavitation, int i) {
  const core::Patch& grid = level.grid;
  const int j = first_line(colour, batch);
  const int k = batch * core::lanes;
  const DistributedShares share = distributed_shares(grid);
  const double* here = level.changes.distributed.at_x(i) + k;
  const double* west = level.changes.distributed.at_x(i - 1) + k;
  const double* east = level.changes.distributed.at_x(i + 1) + k;
  double* P = level.P.at_x(i) + j - 1;
  const Lanes low = core::load(P);
  const Lanes high = core::load(P + core::lanes);
  // Entries after the last line may be those of the other colour.
  Lanes own_lines = inside(j, grid) ? core::load(here) : Lanes{};
  // The distributed change of the line before the batch.
  const Lanes edge = core::broadcast(batch > 0 ? here[-1] : 0.0);
  const Lanes one_south = core::moved_up(edge, own_lines);
  // Beyond the axis of symmetry lies the image of the line before it.
  if (grid.north == core::Edge::mirror) own_lines = lines_from(j) == grid.ny + 1 ? one_south : own_lines;
  Lanes between = reynolds::projected(cavitation, core::evens(low, high) - share.across * (one_south + own_lines));
  Lanes own = reynolds::projected(cavitation, core::odds(low, high) + core::load(level.changes.delta.at_x(i) + k) -
                                                  share.along * (core::load(west) + core::load(east)));
  between = inside(j - 1, grid) ? between : core::evens(low, high);
  own = inside(j, grid) ? own : core::odds(low, high);
  core::store(P, core::interleaved_low(between, own));
  core::store(P + core::lanes, core::interleaved_high(between, own));
}

std::string describe(const line_solvers::SmallPivot& small, int line, const core::Patch& grid) {
  char text[160];
  std::snprintf(text, sizeof text,
                "line relaxation on %d x %d cells: pivot %.3g at point i = %d of line j = %d is negligible compared "
                "with its row (the state has diverged)",
                grid.nx, grid.domain.ny, small.pivot, small.point, line);
  return text;
}

/// The first small pivot in the order of colours and lines, for any number of threads.
struct FirstSmallPivot {
  line_solvers::SmallPivot pivot;
  int colour = 0;
  int line = 0;

  void meet(const line_solvers::SmallPivot& met, int met_colour, int batch) {
    if (met.point < 0) return;
    const int met_line = first_line(met_colour, batch) + 2 * met.lane;
#pragma omp critical
    if (pivot.point < 0 || std::pair(met_colour, met_line) < std::pair(colour, line)) {
      pivot = met;
      colour = met_colour;
      line = met_line;
    }
  }
};

/// Batches with an interior line among their own lines or the lines before these.
int batches_to_apply(const core::Patch& grid, int colour) {
  return (grid.last_line() + 1 - colour + 2 * core::lanes - 1) / (2 * core::lanes);
}

template <int reach, LineSolver solver>
void relax_lines(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  const reynolds::Cavitation cavitation = hierarchy.problem.cavitation;
  const core::Patch& grid = level.grid;
  FirstSmallPivot small;
  if (relaxes_along_line(grid, how, cavitation)) {
    small.meet(relax_along_line<reach>(hierarchy, level, how), 0, 0);
    if (small.pivot.point >= 0) throw core::SolverError(describe(small.pivot, small.line, grid));
    return;
  }
  const auto solve = [&](ThreadWork& work, int colour, int batch) {
    if (batch < batches_of_colour(grid, colour))
      small.meet(LineBatch<reach, solver>(work, how).solve(hierarchy, level, colour, batch), colour, batch);
  };
  const int threads = hierarchy.threads_on(grid);
  if (threads == 1) {
    const auto apply = [&](int colour, int batch) {
      const bool beside_axis = first_line(colour, batch) + 2 * core::lanes > grid.ny;
      for (int i = 1; i < grid.nx; ++i) {
        apply_changes(level, colour, batch, cavitation, i);
        if (beside_axis) core::fill_ghosts(grid, level.P.at_x(i));
      }
    };
    // The second colour follows one batch behind the first, while its lines are still in the cache. A batch of it needs
    // the first colour's changes up to the line after it, and none beyond.
    const int first = batches_to_apply(grid, 0);
    const int second = batches_to_apply(grid, 1);
    for (int batch = 0; batch < std::max(first, second + 1); ++batch) {
      solve(level.thread_work[0], 0, batch);
      if (batch < first) apply(0, batch);
      if (batch > 0 && batch <= second) {
        solve(level.thread_work[0], 1, batch - 1);
        apply(1, batch - 1);
      }
    }
  } else {
    for (int colour = 0; colour < 2; ++colour) {
      const int batches = batches_to_apply(grid, colour);
#pragma omp parallel num_threads(threads)
      {
        ThreadWork& work = level.thread_work[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
        for (int batch = 0; batch < batches; ++batch) solve(work, colour, batch);
#pragma omp for schedule(static)
        for (int i = 1; i < grid.nx; ++i) {
          for (int batch = 0; batch < batches; ++batch) apply_changes(level, colour, batch, cavitation, i);
          core::fill_ghosts(grid, level.P.at_x(i));
        }
      }
    }
  }
  if (small.pivot.point >= 0) throw core::SolverError(describe(small.pivot, small.line, grid));
}

template <int reach>
void relax_lines(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  if (how.line_solver == LineSolver::elimination)
    relax_lines<reach, LineSolver::elimination>(hierarchy, level, how);
  else
    relax_lines<reach, LineSolver::decimation>(hierarchy, level, how);
}

}  // namespace

void relax_pressure(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  const core::ScopedTimer timer(hierarchy.times, core::Part::line_solve);
  switch (how.reach) {
    case 1: relax_lines<1>(hierarchy, level, how); break;
    case 2: relax_lines<2>(hierarchy, level, how); break;
    default: relax_lines<3>(hierarchy, level, how); break;
  }
}

void relax(Hierarchy& hierarchy, Level& level, const RelaxationParameters& how) {
  const bool stretched = core::stretched(level.grid);
  const bool across = (stretched || how.across) && can_relax_across(hierarchy, level);
  RelaxationParameters along = how;
  if (across && !stretched) {
    if (at_half_points(level))
      along.weight_single_steep *= how.steep_before_across;
    else
      along = lighter(how, how.coarse_before_across);
  }
  relax_pressure(hierarchy, level, along);
  if (across) {
    if (stretched)
      update_coefficients(hierarchy, level);
    else
      update_film(hierarchy, level);
    relax_across(hierarchy, level, how);
  }
  update_film(hierarchy, level);
}

}  // namespace ehl::multigrid
