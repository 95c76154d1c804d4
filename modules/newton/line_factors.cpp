#include "newton/line_factors.hpp"

namespace ehl::newton {

bool TouchingLineFactors::factor(Equations& equations, const Slopes& by_P, const Slopes& by_H) {
  using Touch = Equations::Touch;
  const core::Patch& grid = equations.grid();
  const std::size_t nodes = equations.nodes();
  const double s = equations.touching_scale();
  const Eigen::VectorXd K = influence_of_line(equations);
  std::vector<Eigen::Index> of_pressure(nodes, -1);
  unknowns_ = {equations.size() - 1};
  for (std::size_t k = 0; k < nodes; ++k)
    if (equations.wet(k)) {
      of_pressure[k] = static_cast<Eigen::Index>(unknowns_.size());
      unknowns_.push_back(k);
    }
  for (std::size_t k = 0; k < nodes; ++k)
    if (equations.touch(k) != Touch::none) unknowns_.push_back(nodes + k);
  const auto size = static_cast<Eigen::Index>(unknowns_.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  // The change of H at node i by the unknown of each column.
  const auto film = [&](int i, Eigen::Index column) {
    if (column == 0) return 1.0;
    const std::size_t unknown = unknowns_[static_cast<std::size_t>(column)];
    const std::size_t node = unknown % nodes;
    const int there = static_cast<int>(node) + 1;
    if (unknown >= nodes && equations.touch(node) == Touch::yields) return i == there ? 1.0 / s : 0.0;
    return K[grid.nx + i - there];
  };
  for (Eigen::Index row = 0; row < size; ++row) {
    const std::size_t unknown = unknowns_[static_cast<std::size_t>(row)];
    if (row == 0) {
      A(0, 0) = equations.load_by_H00();
      for (Eigen::Index column = 1; column < size; ++column) {
        const std::size_t other = unknowns_[static_cast<std::size_t>(column)];
        if (other < nodes || equations.touch(other - nodes) == Touch::touches)
          A(0, column) = grid.hx() * grid.hy() / equations.level().load;
      }
      continue;
    }
    const std::size_t node = unknown % nodes;
    const int i = static_cast<int>(node) + 1;
    if (unknown >= nodes) {
      for (Eigen::Index column = 0; column < size; ++column) A(row, column) = s * film(i, column);
      continue;
    }
    for (std::size_t m = 0; m < stencil.size(); ++m) {
      const auto [di, dj] = stencil[m];
      if (dj != 0 || i + di < 0 || i + di > grid.nx) continue;
      if (i + di >= 1 && i + di < grid.nx)
        if (const Eigen::Index column = of_pressure[static_cast<std::size_t>(i + di - 1)]; column >= 0)
          A(row, column) += by_P[node][m];
      for (Eigen::Index column = 0; column < size; ++column) A(row, column) += by_H[node][m] * film(i + di, column);
    }
  }
  if (!A.allFinite()) return false;
  lu_.compute(A);
  return true;
}

void TouchingLineFactors::solve(std::span<double> v) const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(unknowns_.size()));
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = v[unknowns_[static_cast<std::size_t>(k)]];
  x = lu_.solve(x).eval();
  for (Eigen::Index k = 0; k < x.size(); ++k) v[unknowns_[static_cast<std::size_t>(k)]] = x[k];
}

}  // namespace ehl::newton
