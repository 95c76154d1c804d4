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

  double hx() const { return (X_b - X_a) / nx; }
  double hy() const { return (Y_b - Y_a) / ny; }
  double X(int i) const { return X_a + i * hx(); }
  double Y(int j) const { return Y_a + j * hy(); }
  int nodes_x() const { return nx + 1; }
  int nodes_y() const { return ny + 1; }
};

inline bool operator==(const Grid& a, const Grid& b) {
  return a.nx == b.nx && a.ny == b.ny && a.X_a == b.X_a && a.X_b == b.X_b && a.Y_a == b.Y_a && a.Y_b == b.Y_b;
}

/// The next coarser grid: every second node. limits: nx and ny must be even.
inline Grid coarsened(const Grid& fine) { return {fine.nx / 2, fine.ny / 2, fine.X_a, fine.X_b, fine.Y_a, fine.Y_b}; }

}  // namespace ehl::core
