#pragma once
// Influence coefficients of the elastic half-space, and for line contacts of the half-plane, for a pressure that is
// constant on each cell.
#include <cstddef>
#include <vector>

namespace ehl::kernel {

/// K(d_x, d_y) = integral of 1/r over a cell of hx x hy centred at (d_x hx, d_y hy), seen from the origin. The film
/// equation multiplies it by 2/pi^2 (eq. 6).
///
/// Near cells: the closed form, the antiderivative y ln(x+r) + x ln(y+r) at the four corners, written with log1p of the
/// differences. Far cells (from 6 cells on), where the four corners would cancel: Gauss quadrature over the cell, whose
/// terms are all positive and whose error (4d)^-2m is below rounding.
///
/// in: d_x, d_y, offset [cells]; hx, hy > 0 [any unit of length, which is that of K]. limits: relative error < 1e-14
/// for 1/4 <= hx/hy <= 4, growing in proportion to the larger of hx/hy and hy/hx.
double influence(int d_x, int d_y, double hx, double hy);

/// Table of K, which is even in both offsets.
struct InfluenceTable {
  int n_x = 0;
  int n_y = 0;
  std::vector<double> K;  ///< (n_x+1) x (n_y+1), d_y fastest

  double operator()(int d_x, int d_y) const {
    const int ax = d_x < 0 ? -d_x : d_x;
    const int ay = d_y < 0 ? -d_y : d_y;
    return K[static_cast<std::size_t>(ax) * static_cast<std::size_t>(n_y + 1) + static_cast<std::size_t>(ay)];
  }
};

/// influence(d_x every_x, d_y every_y, hx, hy) for 0 <= d_x <= n_x, 0 <= d_y <= n_y. With every > 1 it is the kernel of
/// the same cells on a coarser grid, as multilevel multi-integration needs it. Vectorised; equal to influence() up to
/// rounding.
InfluenceTable influence_table(int n_x, int n_y, double hx, double hy, int every_x = 1, int every_y = 1);

/// Delta K (eq. 14): K minus the mean of its four neighbours, the influence of a distributive change of the pressure.
/// Near cells: differences of K. Far cells: the difference of 1/r itself, in a form without cancellation, integrated
/// over the cell. limits: relative error < 1e-12 for hx = hy at any distance; for hx != hy the error is relative to hx
/// hy max(hx,hy)^2/r^3, since Delta K passes through zero.
double distributed_influence(int d_x, int d_y, double hx, double hy);

/// Line contacts: K(d) = -integral of ln|x| over a cell of width hx centred at d hx, seen from the origin. The unit of
/// length is that of hx; another unit adds a constant times the load, which H00 takes up. The film equation multiplies
/// K by 1/pi. Near cells: the antiderivative x ln|x| - x at both ends; far cells, from 6 cells on: Gauss quadrature as
/// above. limits: absolute error < 1e-15 hx (1 + |ln hx|).
double line_influence(int d, double hx);
/// K(d every) of a line contact for 0 <= d <= n.
std::vector<double> line_influence_table(int n, double hx, int every = 1);
/// Delta K of a line contact: K minus the mean of its two neighbours, the influence of a change distributed along the
/// line.
double distributed_line_influence(int d, double hx);

}  // namespace ehl::kernel
