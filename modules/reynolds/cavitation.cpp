#include "reynolds/cavitation.hpp"

#include "transfer/transfer.hpp"

namespace ehl::reynolds {
void drop_beside_dry(Cavitation model, const core::Patch& grid, const core::Field& P, int threads, core::Field& r,
                     Neighbours of) {
  if (!ruptures(model)) return;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int i = 1; i < grid.nx; ++i) {
    const double* here = P.at_x(i);
    // Zero pressure on the boundary is no cavitation: next to it the column itself takes the place of its neighbour.
    const double* west = of == Neighbours::all && i > 1 ? P.at_x(i - 1) : here;
    const double* east = of == Neighbours::all && i < grid.nx - 1 ? P.at_x(i + 1) : here;
    double* out = r.at_x(i);
    if (conserves(model)) {
      for (int j = 1; j <= grid.last_line(); ++j) out[j] = dry(model, here[j]) ? 0.0 : out[j];
      core::fill_ghosts(grid, out);
      continue;
    }
    const auto dry_row = [&](int j) { return (west[j] <= 0.0) | (here[j] <= 0.0) | (east[j] <= 0.0); };
    bool south = dry_row(1);
    bool own = south;
    bool dropped = false;
    const int last = grid.last_line();
    for (int j = 1; j <= last; ++j) {
      const bool north = j < last ? dry_row(j + 1) : own;  // the boundary, too
      if (south | own | north) out[j] = 0.0, dropped = true;
      south = own;
      own = north;
    }
    if (dropped) core::fill_ghosts(grid, out);
  }
}

void restrict_pressure(Cavitation model, const core::Field& fine, const core::Patch& grid, core::Field& coarse) {
  transfer::restrict_injection(fine, coarse);
  if (coarse.nodes_x() == fine.nodes_x()) {
    for (int I = 1; I < grid.nx; ++I) {
      const double* row = fine.at_x(I);
      double* to = coarse.at_x(I);
      for (int J = 1; J <= grid.last_line(); ++J) {
        const int j = grid.finer_line(J);
        if (!dry(model, row[j - 1]) && !dry(model, row[j]) && !dry(model, row[j + 1]))
          to[J] = transfer::mean_of_three(row, j);
      }
      core::fill_ghosts(grid, to);
    }
    return;
  }
  for (int I = 1; I < grid.nx; ++I) {
    const double* rows[] = {fine.at_x(2 * I - 1), fine.at_x(2 * I), fine.at_x(2 * I + 1)};
    double* to = coarse.at_x(I);
    for (int J = 1; J <= grid.last_line(); ++J) {
      const int j = grid.finer_line(J);
      bool any_dry = false;
      for (const double* row : rows)
        any_dry = any_dry || dry(model, row[j - 1]) || dry(model, row[j]) || dry(model, row[j + 1]);
      if (!any_dry) to[J] = transfer::mean_of_nine(rows[0], rows[1], rows[2], j);
    }
    core::fill_ghosts(grid, to);
  }
}

}  // namespace ehl::reynolds
