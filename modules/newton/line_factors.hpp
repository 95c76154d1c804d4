#pragma once
// Dense factors of the Jacobian of a line contact.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "newton/equations.hpp"
#include "newton/slopes.hpp"

namespace ehl::newton {

/// K of a line contact by the distance of two nodes, from -nx to nx: the deformation by a pressure at the first node.
inline Eigen::VectorXd influence_of_line(Equations& equations) {
  const core::Patch& grid = equations.grid();
  core::Field first(grid), film(grid);
  std::ranges::fill(first.station(0), 1.0);
  equations.deform(first, film);
  Eigen::VectorXd K(2 * grid.nx + 1);
  for (int d = 0; d <= grid.nx; ++d) K[grid.nx + d] = K[grid.nx - d] = film(d, 1);
  return K;
}

/// The full Jacobian of a line contact: the load and H00 first, then the nodes. The column of a cavitated node is that
/// of the identity. Columns downstream of the last wet node are not stored, and their rows take no part in the
/// elimination.
template <class Number>
class LineFactors {
 public:
  bool factor(Equations& equations, const Slopes& by_P, const Slopes& by_H);
  /// v <- A^-1 v, with the load as the last entry.
  void solve(std::span<double> v) const {
    Eigen::Map<Eigen::VectorXd> all(v.data(), static_cast<Eigen::Index>(v.size()));
    const Column x = lu_->solve(head(all));
    all.segment(kept_ - 1, behind()) -= (matrix_.bottomRows(behind()) * x).template cast<double>();
    put_head(x, all);
  }
  /// v <- A^-T v.
  void solve_transposed(std::span<double> v) const {
    Eigen::Map<Eigen::VectorXd> all(v.data(), static_cast<Eigen::Index>(v.size()));
    Column rhs = head(all);
    rhs -= matrix_.bottomRows(behind()).transpose() * all.segment(kept_ - 1, behind()).template cast<Number>();
    put_head(lu_->transpose().solve(rhs), all);
  }

 private:
  using All = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  using Column = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
  Eigen::Index behind() const { return matrix_.rows() - kept_; }
  Column head(const Eigen::Map<Eigen::VectorXd>& all) const {
    Column first(kept_);
    first[0] = static_cast<Number>(all[all.size() - 1]);
    first.tail(kept_ - 1) = all.head(kept_ - 1).template cast<Number>();
    return first;
  }
  void put_head(const Column& first, Eigen::Map<Eigen::VectorXd>& all) const {
    all[all.size() - 1] = first[0];
    all.head(kept_ - 1) = first.tail(kept_ - 1).template cast<double>();
  }

  All matrix_;
  Eigen::Index kept_ = 0;                                   // number of stored columns
  std::optional<Eigen::PartialPivLU<Eigen::Ref<All>>> lu_;  // stored in the first rows of matrix_
};

template <class Number>
bool LineFactors<Number>::factor(Equations& equations, const Slopes& by_P, const Slopes& by_H) {
  const core::Patch& grid = equations.grid();
  const Column K = influence_of_line(equations).template cast<Number>();
  const auto nodes = static_cast<Eigen::Index>(equations.nodes());
  kept_ = nodes + 1;
  while (kept_ > 1 && !equations.wet(static_cast<std::size_t>(kept_ - 2))) --kept_;
  matrix_.setZero(nodes + 1, kept_);
  Column of_film(nodes);
  for (std::size_t m = 0; m < stencil.size(); ++m) {
    const auto [di, dj] = stencil[m];
    if (dj != 0) continue;
    for (Eigen::Index row = 0; row < nodes; ++row) {
      const auto k = static_cast<std::size_t>(row);
      of_film[row] = static_cast<Number>(by_H[k][m]);
      if (row + di >= 0 && row + di < kept_ - 1) matrix_(row + 1, row + di + 1) += static_cast<Number>(by_P[k][m]);
    }
    for (Eigen::Index column = 0; column < kept_ - 1; ++column)
      matrix_.col(column + 1).tail(nodes).array() += of_film.array() * K.segment(grid.nx + di - column, nodes).array();
    matrix_.col(0).tail(nodes) += of_film;
  }
  matrix_(0, 0) = static_cast<Number>(equations.load_by_H00());
  matrix_.row(0).tail(kept_ - 1).setConstant(static_cast<Number>(grid.hx() * grid.hy() / equations.level().load));
  for (Eigen::Index k = 0; k < kept_ - 1; ++k)
    if (!equations.wet(static_cast<std::size_t>(k))) {
      matrix_.col(k + 1).setZero();
      matrix_(k + 1, k + 1) = Number{1};
    }
  if (!matrix_.allFinite()) return false;
  auto square = matrix_.topRows(kept_);
  lu_.emplace(square);
  return true;
}

/// The full Jacobian where surfaces touch: H00 and the load first, then the wet nodes with their pressure, then the
/// touching nodes with theirs, or with what they yield. All other unknowns keep their value in a solve.
class TouchingLineFactors {
 public:
  bool factor(Equations& equations, const Slopes& by_P, const Slopes& by_H);
  /// v <- A^-1 v, with the load as the last entry.
  void solve(std::span<double> v) const;

 private:
  std::vector<std::size_t> unknowns_;  // indices in v
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace ehl::newton
