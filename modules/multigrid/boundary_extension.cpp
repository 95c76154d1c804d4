#include "multigrid/boundary_extension.hpp"

#include <algorithm>
#include <vector>

#include "reynolds/flux.hpp"

namespace ehl::multigrid {
namespace {

/// A row of nodes from boundary to boundary, or to the axis of symmetry.
struct Row {
  explicit Row(int cells) : P(static_cast<std::size_t>(cells) + 1), e(P.size() - 1), change(P.size()) {}
  std::size_t last() const { return e.size(); }

  std::vector<double> P;
  std::vector<double> e;       ///< conductance between a node and the next
  std::vector<double> change;  ///< in: at the ends
};

/// How far a change at an end of the row reaches: the number of nodes, and the sum of 1/e up to there.
struct Reach {
  std::size_t nodes = 0;
  double resistance = 0.0;
};
template <class Node>
Reach reach_from(const Row& row, double least, Node node) {
  Reach reach;
  for (; reach.nodes < row.last(); ++reach.nodes) {
    const double e = row.e[std::min(node(reach.nodes), node(reach.nodes + 1))];
    if (!(row.P[node(reach.nodes + 1)] > 0.0) || !(e > least)) break;
    reach.resistance += 1.0 / e;
  }
  return reach;
}
template <class Node>
void extend_row(Row& row, const Reach& reach, double end, Node node) {
  const double begin = row.change[node(0)];
  double passed = 0.0;
  for (std::size_t k = 1; k < reach.nodes; ++k) {
    passed += 1.0 / row.e[std::min(node(k - 1), node(k))];
    const double share = passed / reach.resistance;
    row.change[node(k)] = begin * (1.0 - share) + end * share;
  }
}

void extend_from_ends(Row& row, double least, bool mirror) {
  const auto forward = [](std::size_t k) { return k; };
  const auto back = [&](std::size_t k) { return row.last() - k; };
  std::fill(row.change.begin() + 1, row.change.end() - (mirror ? 0 : 1), 0.0);
  const Reach reach = reach_from(row, least, forward);
  if (reach.nodes == row.last()) {
    if (mirror) row.change.back() = row.change.front();
    return extend_row(row, reach, row.change.back(), forward);
  }
  extend_row(row, reach, 0.0, forward);
  if (!mirror) extend_row(row, reach_from(row, least, back), 0.0, back);
}

}  // namespace

void extend_boundary(const Hierarchy& hierarchy, Level& level) {
  const core::Patch& grid = level.grid;
  const reynolds::HalfInverseSquares half(grid);
  const double least = reynolds::relative_strength(hierarchy.transport, grid.hx());
  const reynolds::Face face = level.scheme.face;
  core::Field& change = level.correction;

  const bool flows_aside = reynolds::flows_aside(grid);
  if (flows_aside) {
    const core::Field& eps = eps_across(level);
    Row row(grid.ny);
    for (int i = 0; i <= grid.nx; ++i) {
      for (int j = 0; j <= grid.ny; ++j) row.P[static_cast<std::size_t>(j)] = level.P(i, j);
      for (int j = 0; j < grid.ny; ++j)
        row.e[static_cast<std::size_t>(j)] = reynolds::conductance(face, eps(i, j), eps(i, j + 1), half.Y);
      row.change.front() = change(i, 0);
      row.change.back() = change(i, grid.ny);
      extend_from_ends(row, least, grid.north == core::Edge::mirror);
      const bool on_boundary = i == 0 || i == grid.nx;
      for (int j = 1; j <= grid.last_line(); ++j) {
        const double led = row.change[static_cast<std::size_t>(j)];
        change(i, j) = on_boundary ? change(i, j) - led : led;
      }
    }
  }

  Row row(grid.nx);
  for (int j = 1; j <= grid.last_line(); ++j) {
    for (int i = 0; i <= grid.nx; ++i) row.P[static_cast<std::size_t>(i)] = level.P(i, j);
    for (int i = 0; i < grid.nx; ++i)
      row.e[static_cast<std::size_t>(i)] = reynolds::conductance(face, level.eps(i, j), level.eps(i + 1, j), half.X);
    row.change.front() = change(0, j);
    row.change.back() = change(grid.nx, j);
    extend_from_ends(row, least, false);
    for (int i = 1; i < grid.nx; ++i) {
      const double led = row.change[static_cast<std::size_t>(i)] + (flows_aside ? change(i, j) : 0.0);
      if (level.P(i, j) > 0.0) level.P(i, j) = std::max(0.0, level.P(i, j) + led);
    }
  }
  core::fill_ghosts(grid, level.P);
}

}  // namespace ehl::multigrid
