#include "transfer/transfer.hpp"

#include <vector>

namespace ehl::transfer {

void restrict_injection(const core::Field& fine, core::Field& coarse) {
  const int every_x = coarse.nodes_x() == fine.nodes_x() ? 1 : 2;
  const int every = coarse.nodes_y() == fine.nodes_y() ? 1 : 2;
  for (int I = 0; I < coarse.nodes_x(); ++I) {
    const double* from = fine.at_x(every_x * I);
    double* to = coarse.at_x(I);
    for (int J = 0; J < coarse.nodes_y(); ++J) to[J] = from[every * J];
  }
}

void restrict_full_weighting(const core::Patch& grid, const core::Field& fine, core::Field& coarse) {
  restrict_injection(fine, coarse);
  if (coarse.nodes_x() == fine.nodes_x()) {
    for (int I = 1; I < coarse.nodes_x() - 1; ++I) {
      double* to = coarse.at_x(I);
      for (int J = 1; J <= grid.last_line(); ++J) to[J] = mean_of_three(fine.at_x(I), grid.finer_line(J));
      core::fill_ghosts(grid, to);
    }
    return;
  }
  for (int I = 1; I < coarse.nodes_x() - 1; ++I) {
    const double* west = fine.at_x(2 * I - 1);
    const double* here = fine.at_x(2 * I);
    const double* east = fine.at_x(2 * I + 1);
    double* to = coarse.at_x(I);
    for (int J = 1; J <= grid.last_line(); ++J) to[J] = mean_of_nine(west, here, east, grid.finer_line(J));
    core::fill_ghosts(grid, to);
  }
}

void prolong_bilinear(const core::Field& coarse, core::Field& fine, int threads) {
  const int columns = fine.nodes_x();
  const int last = coarse.nodes_y() - 1;
  const int every_x = columns == coarse.nodes_x() ? 1 : 2;
  const bool same_lines = fine.nodes_y() == coarse.nodes_y();
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (int i = 0; i < columns; ++i) {
    const double* west = coarse.at_x(i / every_x);
    const double* east = coarse.at_x((i + every_x - 1) / every_x);
    double* to = fine.at_x(i);
    for (int J = 0; same_lines && J <= last; ++J) to[J] = 0.5 * (west[J] + east[J]);
    for (int J = 0; !same_lines && J < last; ++J) {
      const double here = 0.5 * (west[J] + east[J]);
      const double next = 0.5 * (west[J + 1] + east[J + 1]);
      to[2 * J] = here;
      to[2 * J + 1] = 0.5 * (here + next);
    }
    if (!same_lines) to[2 * last] = 0.5 * (west[last] + east[last]);
  }
}

namespace {

// The value half-way between node `left` and the next one. in: value(k), the value at node k, k = 0..last.
template <class Value>
double half_way(Value value, int left, int last) {
  if (left == 0) return (5.0 * value(0) + 15.0 * value(1) - 5.0 * value(2) + value(3)) / 16.0;
  if (left == last - 1)
    return (5.0 * value(last) + 15.0 * value(last - 1) - 5.0 * value(last - 2) + value(last - 3)) / 16.0;
  return (9.0 * (value(left) + value(left + 1)) - value(left - 1) - value(left + 2)) / 16.0;
}

}  // namespace

void prolong_bicubic(const core::Patch& grid, const core::Field& coarse, core::Field& fine) {
  const int last_x = coarse.nodes_x() - 1;
  const int last_y = coarse.nodes_y() - 1;
  const auto at = [&](int i, int J) {
    return i % 2 == 0 ? coarse(i / 2, J) : half_way([&](int I) { return coarse(I, J); }, i / 2, last_x);
  };
  const int every = grid.domain.finer_lines();
  std::vector<double> row(static_cast<std::size_t>(coarse.nodes_y()));  // one column of the fine grid at the coarse Y
  for (int i = 0; i < fine.nodes_x(); ++i) {
    for (int J = 0; J <= last_y; ++J) row[static_cast<std::size_t>(J)] = at(i, J);
    const auto along_y = [&](int J) { return row[static_cast<std::size_t>(J <= last_y ? J : grid.holder(J))]; };
    for (int j = 0; j < fine.nodes_y(); ++j)
      fine(i, j) = every == 1 ? at(i, j) : j % 2 == 0 ? along_y(j / 2) : half_way(along_y, j / 2, grid.domain.ny);
  }
}

}  // namespace ehl::transfer
