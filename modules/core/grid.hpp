#pragma once
// The uniform grid of the discretised contact problem.
namespace ehl::core {

/// A uniform grid of nx x ny cells on [X_a, X_b] x [Y_a, Y_b]; nodes are (0..nx, 0..ny).
/// Dimensionless lengths in Hertz radii a; x is the direction of entrainment, the inlet at X_a.
struct Grid {
  int nx = 0;        ///< cells along x
  int ny = 0;        ///< cells along y
  double X_a = 0.0;  ///< inlet boundary
  double X_b = 0.0;  ///< outlet boundary
  double Y_a = 0.0;  ///< lower side boundary
  double Y_b = 0.0;  ///< upper side boundary
  /// True: the lower half of a domain that is symmetric in Y. Y_b = 0 is then the axis, where the unknowns go on as
  /// their own mirror image.
  bool mirrored = false;

  double hx() const { return (X_b - X_a) / nx; }
  double hy() const { return (Y_b - Y_a) / ny; }
  double X(int i) const { return X_a + i * hx(); }
  double Y(int j) const { return Y_a + j * hy(); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }
  /// The last line of unknowns: the one before the boundary, or the axis.
  int last_line() const { return mirrored ? ny : ny - 1; }
  /// How many lines of the whole domain line j stands for.
  double lines(int j) const { return mirrored && j < ny ? 2.0 : 1.0; }
};

inline bool operator==(const Grid& a, const Grid& b) {
  return a.nx == b.nx && a.ny == b.ny && a.X_a == b.X_a && a.X_b == b.X_b && a.Y_a == b.Y_a && a.Y_b == b.Y_b &&
         a.mirrored == b.mirrored;
}

/// The next coarser grid: every second node. limits: nx and ny must be even.
inline Grid coarsened(const Grid& fine) {
  Grid coarse = fine;
  coarse.nx /= 2;
  coarse.ny /= 2;
  return coarse;
}

/// The lower half of a grid. limits: Y_a = -Y_b and ny even.
inline Grid lower_half(const Grid& whole) {
  return {whole.nx, whole.ny / 2, whole.X_a, whole.X_b, whole.Y_a, 0.0, true};
}

/// The grid of the whole domain: of a mirrored one with its other half.
inline Grid whole(const Grid& grid) {
  if (!grid.mirrored) return grid;
  return {grid.nx, 2 * grid.ny, grid.X_a, grid.X_b, grid.Y_a, -grid.Y_a, false};
}

}  // namespace ehl::core
