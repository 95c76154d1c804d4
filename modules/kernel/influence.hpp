#pragma once
// Influence coefficients of the elastic half-space for a pressure that is constant on each cell.
#include <vector>

namespace ehl::kernel {

/// K(d_x, d_y) = integral of 1/r over a cell of hx x hy centred at (d_x hx, d_y hy), seen from the origin, exact:
/// a quarter-plane antiderivative y ln(x+r) + x ln(y+r) at the four corners, rearranged so that nothing cancels far away.
/// The film equation multiplies it by 2/pi^2 (eq. 6).
double influence(int d_x, int d_y, double hx, double hy);

/// Symmetric table of K for |d_x| <= n_x, |d_y| <= n_y.
struct InfluenceTable {
  int n_x = 0;
  int n_y = 0;
  double hx = 0.0;
  double hy = 0.0;
  std::vector<double> K;  ///< (n_x+1) x (n_y+1), d_y fastest

  double operator()(int d_x, int d_y) const {
    const int ax = d_x < 0 ? -d_x : d_x;
    const int ay = d_y < 0 ? -d_y : d_y;
    return K[static_cast<std::size_t>(ax) * static_cast<std::size_t>(n_y + 1) + static_cast<std::size_t>(ay)];
  }
};

InfluenceTable influence_table(int n_x, int n_y, double hx, double hy);

/// Delta K (eq. 14): K minus the mean of its four neighbours, evaluated without cancellation far away
/// (relative error below 1e-10 at any distance).
double distributed_influence(int d_x, int d_y, double hx, double hy);

}  // namespace ehl::kernel
