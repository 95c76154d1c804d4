#pragma once
// Grid of a discretised domain, and the patch of it on which a level computes.
#include <algorithm>
#include <limits>

namespace ehl::core {

/// Uniform grid of nx x ny cells on [X_a, X_b] x [Y_a, Y_b]; nodes are (0..nx, 0..ny). Dimensionless lengths in Hertz
/// radii a; x is the direction of entrainment, with the inlet at X_a.
struct Grid {
  int nx = 0;        ///< cells along x
  int ny = 0;        ///< cells along y
  double X_a = 0.0;  ///< inlet boundary
  double X_b = 0.0;  ///< outlet boundary
  double Y_a = 0.0;  ///< lower side boundary
  double Y_b = 0.0;  ///< upper side boundary
  /// True for a line contact, where nothing varies along Y: three lines, of which the outer two are copies of the
  /// middle one, and cells of unit width. limits: as made by line_grid().
  bool line = false;

  double hx() const { return (X_b - X_a) / nx; }
  double hy() const { return (Y_b - Y_a) / ny; }
  double X(int i) const { return X_a + i * hx(); }
  double Y(int j) const { return line ? 0.0 : Y_a + j * hy(); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }
  /// Distance from one line to the next: hy. The cells of a line contact have no end along Y: there it is infinite,
  /// while hy = 1 is the width for which loads and flows are counted.
  double between_lines() const { return line ? std::numeric_limits<double>::infinity() : hy(); }
  /// Lines of a grid finer by `times` for each line of this one: `times`; one in a line contact.
  int finer_lines(int times = 2) const { return line ? 1 : times; }
  /// Longest side of a cell that ends.
  double longest_step() const { return line ? hx() : std::max(hx(), hy()); }

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Grid of a line contact.
inline Grid line_grid(int nx, double X_a, double X_b) {
  return {.nx = nx, .ny = 2, .X_a = X_a, .X_b = X_b, .Y_a = -1.0, .Y_b = 1.0, .line = true};
}

/// What lies behind an edge of a patch. (A patch that covers a part of its domain will have a third kind: values from
/// the coarser level.)
enum class Edge {
  zero,   ///< the boundary of the domain, with zero pressure; of a line contact a copy of its one line
  mirror  ///< the mirror image of the patch; the nodes on the edge are unknowns
};

/// A rectangle of a grid: nodes (0..nx, 0..ny), beginning at node (i0, j0) of the domain's grid. Its edges are those of
/// the domain except the north one. Values behind a mirror are stored in ghost lines (field.hpp), so that stencils need
/// no special case.
struct Patch {
  Grid domain;
  int i0 = 0;
  int j0 = 0;
  int nx = 0;
  int ny = 0;
  Edge north = Edge::zero;

  Patch() = default;
  /// The whole domain.
  Patch(const Grid& grid) : domain(grid), nx(grid.nx), ny(grid.ny) {}

  double hx() const { return domain.hx(); }
  double hy() const { return domain.hy(); }
  double X(int i) const { return domain.X(i0 + i); }
  double Y(int j) const { return domain.Y(j0 + j); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }
  /// Last line of unknowns; the first is 1.
  int last_line() const { return north == Edge::mirror ? ny : ny - 1; }
  /// Number of lines of the domain that line j represents.
  double lines(int j) const {
    if (domain.line) return j == 1 ? 1.0 : 0.0;
    return north == Edge::mirror && j < ny ? 2.0 : 1.0;
  }
  /// Line of the patch that holds the values of line j of the domain: j or its mirror image.
  int holder(int j) const { return north == Edge::mirror && j > ny ? 2 * ny - j : j; }
  /// Line of a patch finer by `times` that coincides with line J of this one.
  int finer_line(int J, int times = 2) const { return domain.finer_lines(times) * J; }

  friend bool operator==(const Patch&, const Patch&) = default;
};

/// Next coarser grid: every second node; for a line contact only along X. limits: nx and ny must be even.
inline Grid coarsened(const Grid& fine) {
  Grid coarse = fine;
  coarse.nx /= 2;
  coarse.ny /= fine.finer_lines();
  return coarse;
}
/// Grid with `times` as many cells; for a line contact only along X.
inline Grid refined(const Grid& coarse, int times = 2) {
  Grid fine = coarse;
  fine.nx *= times;
  fine.ny *= coarse.finer_lines(times);
  return fine;
}
/// coarsened() for a patch. limits: i0 and j0 must be even too.
inline Patch coarsened(const Patch& fine) {
  Patch coarse = fine;
  coarse.domain = coarsened(fine.domain);
  coarse.i0 /= 2;
  coarse.j0 /= 2;
  coarse.nx /= 2;
  coarse.ny /= fine.domain.finer_lines();
  return coarse;
}

/// True for cells at least sqrt(2) times as long along X as across it: in the discrete Laplacian the coupling across is
/// then at least twice as strong.
inline bool stretched(const Patch& grid) {
  const double between = grid.domain.between_lines();
  return grid.hx() * grid.hx() > 1.999 * between * between;
}
/// hx/hy of stretched cells; 1 for all others.
inline double stretch(const Patch& grid) { return stretched(grid) ? grid.hx() / grid.hy() : 1.0; }

/// Every second line, and all nodes along X. limits: j0 and ny must be even.
inline Patch coarsened_across(const Patch& fine) {
  Patch coarse = fine;
  coarse.domain.ny /= 2;
  coarse.j0 /= 2;
  coarse.ny /= 2;
  return coarse;
}

/// Lower half of a domain whose unknowns are even in Y, with the axis as mirror. limits: Y_a = -Y_b and ny even.
inline Patch lower_half(const Grid& domain) {
  Patch half = domain;
  half.ny = domain.ny / 2;
  half.north = Edge::mirror;
  return half;
}

}  // namespace ehl::core
