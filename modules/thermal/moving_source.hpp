#pragma once
// Surface temperature of a moving half-space under a heat flux.
//
//   k theta(X, Y) = 1/(2 pi) iint q(X', Y') exp[-(Pe/2)(r - (X - X'))]/r dX' dY',   Pe = u a/kappa,
//
// lengths in a; u along +x. Pe = 0: 1/r, the kernel of the elastic deformation. Pe -> infinity: heat flows only
// downwards, and lines of constant Y are independent (Carslaw and Jaeger),
//   k theta(X) = (pi Pe)^(-1/2) int q(X')/sqrt(X - X') dX'.
// source: Carslaw and Jaeger, Conduction of Heat in Solids, 1959, 10.7; Blok 1937, Jaeger 1942.
#include <cstddef>
#include <vector>

namespace ehl::thermal {

/// G(d_x, d_y): k theta at d_x cells downstream and d_y cells sideways of a cell of hx x hy with unit flux.
struct SourceTable {
  int n_x = 0;              ///< -n_x <= d_x <= n_x
  int n_y = 0;              ///< |d_y| <= n_y
  std::vector<double> G{};  ///< (2 n_x + 1) x (n_y + 1), d_y fastest

  std::size_t at(int d_x, int d_y) const {
    return static_cast<std::size_t>(d_x + n_x) * static_cast<std::size_t>(n_y + 1) +
           static_cast<std::size_t>(d_y < 0 ? -d_y : d_y);
  }
  double operator()(int d_x, int d_y) const { return G[at(d_x, d_y)]; }
};

/// Green's function of an instantaneous source, integrated over the cell in closed form and over s = sqrt(time) by
/// Gauss quadrature:
///   G = 2/sqrt(pi) int A_x(s) A_y(s) ds,   A_x = [erf((X - Pe s^2 + hx/2)/2s) - erf((X - Pe s^2 - hx/2)/2s)]/2,
/// and A_y in the same way with Pe = 0. All offsets share the nodes s; entries that a node s does not reach cost
/// nothing. hy = INFINITY: infinite strips (A_y = 1), n_y = 0; they need Pe > 0, because at rest there is no steady
/// state. in: Pe >= 0. error: 1e-6 of the largest entry; of a flash temperature: [bench: thermal_cells_of_source].
SourceTable moving_source_table(int n_x, int n_y, double hx, double hy, double Pe);

/// Weights for line sources (Carslaw and Jaeger) with a flux linear between nodes:
///   theta_i = sum_m w_m q_{i-m}, m = 0..n.
/// in: Pe > 0. order: 2 for smooth q, 1.5 if q begins with a jump.
std::vector<double> line_weights(int n, double hx, double Pe);

/// Subtracts the line sources from the table. The rest is conduction sideways and upstream, and that of another Pe.
void subtract_lines(const std::vector<double>& weights, SourceTable& table);

/// Moves the entries G(0..n_x) of a table of strips, a cell's own response and that downstream, to weights like those
/// of line sources. The upstream entries remain; they are small for large Pe. in: n_y = 0.
std::vector<double> take_downstream(SourceTable& table);

}  // namespace ehl::thermal
