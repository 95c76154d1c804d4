#pragma once
// Sparse symmetric systems of conductances, solved by conjugate gradients with aggregation multigrid.
#include <cstddef>
#include <vector>

namespace ehl::asperities {

/// A x at row i: diagonal_i x_i - sum over k of first[i] .. first[i+1] of conductance_k x_(column_k). Conductances are
/// > 0 and symmetric, and the diagonal is at least their sum: the network is passive.
struct Network {
  std::vector<double> diagonal{};
  std::vector<std::size_t> first{};  ///< rows + 1 numbers
  std::vector<int> column{};
  std::vector<double> conductance{};

  int rows() const { return static_cast<int>(diagonal.size()); }
};

/// What the iteration reached.
struct NetworkSolution {
  std::vector<double> x{};
  double residual = 0.0;  ///< over the right-hand side, both as the root of the sum of squares
  int iterations = 0;
};

/// Solves A x = b by flexible conjugate gradients. One iteration of the preconditioner is a K-cycle: two steps of
/// flexible conjugate gradients on each coarser network, which is made of pairs of pairs of strongly connected nodes;
/// symmetric Gauss-Seidel smooths. The convergence hardly depends on the number of nodes or on how much the
/// conductances differ. limits: every node is connected, over others if need be, with one whose diagonal exceeds the
/// sum of its conductances. source: Notay (2010), Electron. Trans. Numer. Anal. 37, 123.
NetworkSolution solve(const Network& network, const std::vector<double>& b, double tolerance, int max_iterations);

}  // namespace ehl::asperities
