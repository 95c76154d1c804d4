#pragma once
// The lattice of a discretised domain, and the patch of it on which a level computes.
namespace ehl::core {

/// A uniform lattice of nx x ny cells on [X_a, X_b] x [Y_a, Y_b]; nodes are (0..nx, 0..ny).
/// Dimensionless lengths in Hertz radii a; x is the direction of entrainment, the inlet at X_a.
struct Grid {
  int nx = 0;        ///< cells along x
  int ny = 0;        ///< cells along y
  double X_a = 0.0;  ///< inlet boundary
  double X_b = 0.0;  ///< outlet boundary
  double Y_a = 0.0;  ///< lower side boundary
  double Y_b = 0.0;  ///< upper side boundary
  /// Of a line contact, where nothing changes along Y: three lines, of which the outer two are copies of the middle
  /// one, and a cell across is the unit of length. limits: as line_grid() makes it.
  bool line = false;

  double hx() const { return (X_b - X_a) / nx; }
  double hy() const { return (Y_b - Y_a) / ny; }
  double X(int i) const { return X_a + i * hx(); }
  double Y(int j) const { return line ? 0.0 : Y_a + j * hy(); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// The lattice of a line contact.
inline Grid line_grid(int nx, double X_a, double X_b) {
  return {.nx = nx, .ny = 2, .X_a = X_a, .X_b = X_b, .Y_a = -1.0, .Y_b = 1.0, .line = true};
}

/// What stands behind an edge of a patch. (A patch that covers a part of its domain will have a third kind: values from
/// the coarser level.)
enum class Edge {
  zero,    ///< the boundary of the domain, where the pressure is zero
  mirror,  ///< the domain goes on as the image of the patch; the edge itself belongs to the unknowns
  uniform  ///< of a line contact, on both sides: what stands there are copies of the one line of unknowns
};

/// A rectangle of a lattice: nodes (0..nx, 0..ny) from node (i0, j0) of the domain's lattice on. Its edges are the
/// domain's, but for the one to the north. What stands behind a mirror is kept in ghost lines (field.hpp), so that a
/// stencil asks for no edge.
struct Patch {
  Grid domain;
  int i0 = 0;
  int j0 = 0;
  int nx = 0;
  int ny = 0;
  Edge north = Edge::zero;

  Patch() = default;
  /// All of the domain.
  Patch(const Grid& grid) : domain(grid), nx(grid.nx), ny(grid.ny), north(grid.line ? Edge::uniform : Edge::zero) {}

  double hx() const { return domain.hx(); }
  double hy() const { return domain.hy(); }
  double X(int i) const { return domain.X(i0 + i); }
  double Y(int j) const { return domain.Y(j0 + j); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }
  /// The last line of unknowns; the first is 1.
  int last_line() const { return north == Edge::mirror ? ny : ny - 1; }
  /// How many lines of the domain line j stands for.
  double lines(int j) const {
    if (north == Edge::uniform) return j == 1 ? 1.0 : 0.0;
    return north == Edge::mirror && j < ny ? 2.0 : 1.0;
  }
  /// The line that holds the values of line j of the domain: j, or that of which it is the image.
  int holder(int j) const { return north == Edge::mirror && j > ny ? 2 * ny - j : j; }
  /// The line of a finer patch that is line J of this one; finer `times` times.
  int finer_line(int J, int times = 2) const { return north == Edge::uniform ? J : times * J; }

  friend bool operator==(const Patch&, const Patch&) = default;
};

/// The next coarser lattice: every second node; of a line contact along X alone. limits: nx and ny must be even.
inline Grid coarsened(const Grid& fine) {
  Grid coarse = fine;
  coarse.nx /= 2;
  if (!fine.line) coarse.ny /= 2;
  return coarse;
}
/// The lattice with `times` as many cells; of a line contact along X alone.
inline Grid refined(const Grid& coarse, int times = 2) {
  Grid fine = coarse;
  fine.nx *= times;
  if (!coarse.line) fine.ny *= times;
  return fine;
}
/// coarsened() of a patch. limits: i0, j0 too.
inline Patch coarsened(const Patch& fine) {
  Patch coarse = fine;
  coarse.domain = coarsened(fine.domain);
  coarse.i0 /= 2;
  coarse.j0 /= 2;
  coarse.nx /= 2;
  if (!fine.domain.line) coarse.ny /= 2;
  return coarse;
}

/// Cells at least sqrt(2) times as long along X as across it: across it two neighbours are coupled at least twice as
/// strongly by a pressure's curvature.
inline bool stretched(const Patch& grid) {
  return !grid.domain.line && grid.hx() * grid.hx() > 1.999 * grid.hy() * grid.hy();
}
/// hx/hy of such cells; 1 of all others.
inline double stretch(const Patch& grid) { return stretched(grid) ? grid.hx() / grid.hy() : 1.0; }

/// Every second line of it, and all stations along X. limits: j0 and ny must be even.
inline Patch coarsened_across(const Patch& fine) {
  Patch coarse = fine;
  coarse.domain.ny /= 2;
  coarse.j0 /= 2;
  coarse.ny /= 2;
  return coarse;
}

/// The lower half of a domain whose unknowns are even in Y, the axis its mirror. limits: Y_a = -Y_b and ny even.
inline Patch lower_half(const Grid& domain) {
  Patch half = domain;
  half.ny = domain.ny / 2;
  half.north = Edge::mirror;
  return half;
}

}  // namespace ehl::core
