#pragma once
// The temperature of a moving half space under the heat that flows into its surface.
//
//   k theta(X, Y) = 1/(2 pi) iint q(X', Y') exp[-(Pe/2)(r - (X - X'))]/r dX' dY',   Pe = u a/kappa,
// in lengths of a; u along +x. Pe = 0: 1/r, the kernel of the elastic deformation. Pe -> infinity: heat flows downwards
// only, and a line of constant Y is its own world (Carslaw and Jaeger),
//   k theta(X) = (pi Pe)^(-1/2) int q(X')/sqrt(X - X') dX'.
// source: Carslaw and Jaeger, Conduction of Heat in Solids, 1959, 10.7; Blok 1937, Jaeger 1942.
#include <cstddef>
#include <vector>

namespace ehl::thermal {

/// G(d_x, d_y): what unit flux per conductivity in a cell of hx x hy makes at d_x cells downstream and d_y beside.
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

/// By Green's function of an instantaneous source, integrated over the cell in closed form and over s = sqrt(time) by
/// Gauss: G = 2/sqrt(pi) int A_x(s) A_y(s) ds, A_x = [erf((X - Pe s^2 + hx/2)/2s) - erf((X - Pe s^2 - hx/2)/2s)]/2, A_y
/// likewise at rest. All offsets share the nodes s, so that an entry takes one product per node that its cell feels.
/// hy = INFINITY: cells of endless strips (A_y = 1; n_y = 0 and Pe > 0, for at rest their rise has no end).
/// in: Pe >= 0. error: 1e-6 of the largest entry. cost: at 257 x 257 nodes 20 to 60 ms.
SourceTable moving_source_table(int n_x, int n_y, double hx, double hy, double Pe);

/// Of Carslaw and Jaeger's lines with a flux that is linear between nodes: theta_i = sum_m w_m q_{i-m}, m = 0..n.
/// in: Pe > 0. order: 2 where q is smooth, 1.5 where it begins with a jump.
std::vector<double> line_weights(int n, double hx, double Pe);

/// Takes the lines out of the table: what is left to the neighbours, to upstream, and to Pe.
void subtract_lines(const std::vector<double>& weights, SourceTable& table);

/// Takes out of a table of strips what a cell makes of itself and downstream, G(0..n_x): weights as those of lines.
/// What is left is upstream, little where Pe is large. in: n_y = 0.
std::vector<double> take_downstream(SourceTable& table);

}  // namespace ehl::thermal
