#include "newton/slopes.hpp"

#include <vector>

#include "reynolds/flux.hpp"

namespace ehl::newton {
namespace {

/// Nodes of one colour, i + 3 j modulo `count`, are changed together: no equation depends on two of them. For a line
/// contact j does not count, and no equation depends on nodes beside the line.
struct Colours {
  int count;
  std::size_t nodes;  ///< number of stencil nodes used
  bool line = false;
  int of(int i, int j) const { return line ? i % count : (i + 3 * j) % count; }
  bool sees(int dj) const { return !line || dj == 0; }
};
Colours colours_of(By by, bool across) {
  const std::size_t nodes = by == By::pressure ? 6 : stencil.size();
  if (!across) return {by == By::pressure ? 4 : 5, nodes, true};
  return {by == By::pressure ? 7 : 10, nodes};
}

}  // namespace

Slopes slopes(Equations& equations, By by) {
  const core::Patch& grid = equations.grid();
  const std::size_t rows = equations.size() - 1;
  core::Field dP(grid), dH(grid);
  Slopes slopes(rows);
  std::vector<double> dr(rows);
  const Colours colours = colours_of(by, reynolds::flows_aside(grid));
  for (int chosen = 0; chosen < colours.count; ++chosen) {
    core::Field& changed = by == By::pressure ? dP : dH;
    (by == By::pressure ? dH : dP).fill(0.0);
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) changed(i, j) = colours.of(i, j) == chosen ? 1.0 : 0.0;
    core::fill_ghosts(grid, dP);
    equations.change_of_residual(dP, dH, dr);
    for (int i = 1; i < grid.nx; ++i)
      for (int j = 1; j <= grid.last_line(); ++j)
        for (std::size_t k = 0; k < colours.nodes; ++k) {
          const auto [di, dj] = stencil[k];
          const bool there = colours.sees(dj) && i + di >= 0 && i + di <= grid.nx && j + dj >= 0 && j + dj <= grid.ny;
          const std::size_t row = equations.index(i, j);
          if (there && colours.of(i + di, j + dj) == chosen) slopes[row][k] = equations.scale(row) * dr[row];
        }
  }
  return slopes;
}

}  // namespace ehl::newton
