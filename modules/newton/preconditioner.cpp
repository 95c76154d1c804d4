#include "newton/preconditioner.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "newton/line_factors.hpp"
#include "reynolds/row.hpp"

namespace ehl::newton {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// A part [i_first, i_last] x [j_first, j_last] of the grid.
struct Box {
  int i_first, i_last, j_first, j_last;
  int width() const { return i_last - i_first + 1; }
  int height() const { return j_last - j_first + 1; }
};

// A box of at most this size is eliminated as a dense block.
constexpr int leaf = 3;

/// Nested dissection of the rectangular grid: first one half, then the other, last the separator. A separator of
/// constant X must be as thick as the wedge reaches upstream; one of constant Y is one node thick.
void dissect(const Box& box, int reach, const Equations& equations, std::vector<std::pair<int, int>>& order) {
  if (box.width() <= 0 || box.height() <= 0) return;
  const auto take = [&](const Box& part) {
    for (int i = part.i_first; i <= part.i_last; ++i)
      for (int j = part.j_first; j <= part.j_last; ++j)
        if (equations.wet(equations.index(i, j))) order.emplace_back(i, j);
  };
  if (box.width() <= leaf + reach && box.height() <= leaf) return take(box);
  const bool across_x = box.width() > leaf + reach && (box.height() <= leaf || reach * box.height() < box.width());
  Box low = box, high = box, separator = box;
  if (across_x) {
    separator.i_first = box.i_first + (box.width() - reach) / 2;
    separator.i_last = separator.i_first + reach - 1;
    low.i_last = separator.i_first - 1;
    high.i_first = separator.i_last + 1;
  } else {
    separator.j_first = separator.j_last = box.j_first + box.height() / 2;
    low.j_last = separator.j_first - 1;
    high.j_first = separator.j_last + 1;
  }
  dissect(low, reach, equations, order);
  dissect(high, reach, equations, order);
  take(separator);
}

}  // namespace

struct Preconditioner::Implementation {
  Equations& equations;
  std::vector<std::pair<int, int>> order;  // wet nodes in the order of elimination
  std::vector<int> place;                  // of a node in `order`; -1: cavitated
  Matrix matrix;
  Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>> lu;
  Vector border;    // J~^-1 of the column of H00, without the load row
  Vector load_row;  // d F_last / d P at each node
  double schur = 0.0;
  Vector rhs, solution;

  // For a line contact one of these factorizations is used:
  LineFactors<double> line_factors;
  LineFactors<float> line_factors_single;
  TouchingLineFactors touching_line_factors;
  const bool single;
  const std::size_t dense_up_to;

  Implementation(Equations& e, bool of_single, std::size_t most) : equations(e), single(of_single), dense_up_to(most) {}
  bool line() const {
    return equations.grid().domain.line && (equations.touching() || equations.size() <= dense_up_to);
  }
  bool factor_dense(const Slopes& by_P, const Slopes& by_H) {
    if (equations.touching()) return touching_line_factors.factor(equations, by_P, by_H);
    return single ? line_factors_single.factor(equations, by_P, by_H) : line_factors.factor(equations, by_P, by_H);
  }
  bool factor_sparse();
  Eigen::Index size() const { return static_cast<Eigen::Index>(order.size()); }
  /// Index in u and F of the k-th node of the order.
  std::size_t node(Eigen::Index k) const {
    const auto [i, j] = order[static_cast<std::size_t>(k)];
    return equations.index(i, j);
  }
  void make_order();
  void assemble(Vector& column_of_H00);
  /// Calls action(node, k) for the nodes where the surfaces touch, k the index of w in u.
  template <class Action>
  void for_touching(Action action) const {
    if (!equations.touching()) return;
    for (std::size_t node = 0; node < equations.nodes(); ++node)
      if (equations.touch(node) != Equations::Touch::none) action(node, equations.nodes() + node);
  }
  /// What the load changes by the unknown w of a node where the surfaces touch: nothing where they yield.
  double load_of(std::size_t node) const;
  void subtract_known_film(std::span<const double> v);
  void solve_touching(double dH00, std::span<double> v) const;

  core::Field dP, dH;          // work space of subtract_known_film()
  std::vector<double> change;  // the same
};

void Preconditioner::Implementation::make_order() {
  const core::Patch& grid = equations.grid();
  order.clear();
  const int reach = equations.transport().wedge == reynolds::Wedge::upstream1 ? 1 : 2;
  dissect({1, grid.nx - 1, 1, grid.last_line()}, reach, equations, order);
  place.assign(equations.nodes(), -1);
  for (Eigen::Index k = 0; k < size(); ++k) place[node(k)] = static_cast<int>(k);
}

void Preconditioner::Implementation::assemble(Vector& column_of_H00) {
  const core::Patch& grid = equations.grid();
  const multigrid::Level& level = equations.level();
  const reynolds::NodeRows rows = equations.rows();
  const core::Field& dq = equations.local().q;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * order.size());
  for (std::size_t row = 0; row < order.size(); ++row) {
    const int i = order[row].first, j = order[row].second;
    const double s = equations.scale(equations.index(i, j));
    const reynolds::Face face = equations.face();
    const ContentRows* content = equations.content_rows();
    const auto c = content != nullptr ? content->at(i, j).weights : rows.weights(i, j);
    const auto enter = [&](int ci, int line, double value) {
      const int cj = grid.holder(line);
      if (ci < 1 || ci >= grid.nx || cj < 1 || cj > grid.last_line()) return;
      const int column = place[equations.index(ci, cj)];
      if (column >= 0) entries.emplace_back(static_cast<int>(row), column, s * value);
    };
    double& of_H00 = column_of_H00[static_cast<Eigen::Index>(row)];
    of_H00 = 0.0;
    // Adds the row of node k with these weights. Upstream dry nodes, whose outflow equals their inflow, are added
    // without weights of their own film.
    const auto enter_row = [&](int k, const std::array<double, 4>& w) {
      const auto in_columns = [&](const core::Field& field) {
        return reynolds::columns_at(k, [&](int column) { return field(column, j); });
      };
      const auto held = reynolds::by_pressure(w, rows.faces(k, j), in_columns(dq));
      const auto dr = face == reynolds::Face::mean
                          ? reynolds::follow_epsilon(held, level.P, equations.local().eps, equations.local_eps_across(),
                                                     k, j, rows.half())
                          : reynolds::follow_epsilon(held, level.P, equations.local().eps, equations.local().eps_behind,
                                                     equations.local().eps_across, equations.local().eps_across_behind,
                                                     k, j, rows.half());
      enter(k, j, dr.own);
      enter(k - 1, j, dr.west);
      enter(k + 1, j, dr.east);
      enter(k, j - 1, dr.south);
      enter(k, j + 1, dr.north);
      if (w[2] != 0.0) enter(k - 2, j, dr.far_west);
      const auto de_dH00 =
          reynolds::faces_at(face, equations.deps_dH00(), equations.deps_dH00_across(), k, j, rows.half());
      of_H00 += s * reynolds::residual(w, de_dH00, in_columns(equations.dq_dH00()), reynolds::cross_at(level.P, k, j));
    };
    enter_row(i, c);
    if (content == nullptr) continue;
    const double per_step = equations.transport().speed / grid.hx();
    for (int k = i - 1; k >= 1 && content->at(k + 1, j).behind_dry; --k) {
      const bool last = k > 1 && !content->at(k, j).behind_dry;
      const std::array<double, 3> passed = last ? content->at(k - 1, j).behind : std::array<double, 3>{};
      enter_row(k, {0.0, -per_step * passed[0], -per_step * passed[1], 0.0});
    }
  }
  matrix.resize(size(), size());
  matrix.setFromTriplets(entries.begin(), entries.end());
}

bool Preconditioner::Implementation::factor_sparse() {
  make_order();
  if (order.empty()) return false;
  Vector column(size());
  assemble(column);
  lu.setPivotThreshold(1e-3);
  lu.analyzePattern(matrix);
  lu.factorize(matrix);
  if (lu.info() != Eigen::Success) return false;
  border = lu.solve(column);
  const core::Patch& grid = equations.grid();
  load_row.resize(size());
  std::ranges::transform(order, load_row.begin(), [&](const auto& node) {
    // Where surfaces touch, the film is known, and with it the sum of both pressures.
    if (equations.touch(equations.index(node.first, node.second)) == Equations::Touch::touches) return 0.0;
    return grid.hx() * grid.hy() * grid.lines(node.second) / equations.level().load;
  });
  schur = load_row.dot(border);
  for_touching([&](std::size_t node, std::size_t) { schur += load_of(node) * equations.touching_scale(); });
  rhs.resize(size());
  return border.allFinite() && schur != 0.0;
}

double Preconditioner::Implementation::load_of(std::size_t node) const {
  if (equations.touch(node) == Equations::Touch::yields) return 0.0;
  const core::Patch& grid = equations.grid();
  const int j = static_cast<int>(node % static_cast<std::size_t>(grid.last_line())) + 1;
  return grid.hx() * grid.hy() * grid.lines(j) / equations.level().load;
}

// The change of H where the surfaces touch follows from their own rows, and changes the rows of the fluid.
void Preconditioner::Implementation::subtract_known_film(std::span<const double> v) {
  const core::Patch& grid = equations.grid();
  if (dP.nodes_x() == 0) {
    dP = dH = core::Field(grid);
    change.resize(equations.nodes());
  }
  dH.fill(0.0);
  const auto lines = static_cast<std::size_t>(grid.last_line());
  for_touching([&](std::size_t node, std::size_t k) {
    dH(static_cast<int>(node / lines) + 1, static_cast<int>(node % lines) + 1) = v[k] / equations.touching_scale();
  });
  equations.change_of_residual(dP, dH, change);
  for (Eigen::Index k = 0; k < size(); ++k) rhs[k] -= equations.scale(node(k)) * change[node(k)];
}

// in: v: the fluid's pressure is known; out: that of touching surfaces, or what they yield.
void Preconditioner::Implementation::solve_touching(double dH00, std::span<double> v) const {
  const double s = equations.touching_scale();
  const auto fluid = [&](std::size_t node) { return equations.wet(node) ? v[node] : 0.0; };
  for_touching([&](std::size_t node, std::size_t k) { v[k] += -s * dH00 - fluid(node); });
}

Preconditioner::Preconditioner(Equations& equations, Precision of_dense, std::size_t dense_up_to)
    : implementation_(std::make_unique<Implementation>(equations, of_dense == Precision::single, dense_up_to)) {}
Preconditioner::~Preconditioner() = default;

bool Preconditioner::factor() {
  Implementation& own = *implementation_;
  return own.line() ? own.factor_dense(slopes(own.equations, By::pressure), slopes(own.equations, By::film))
                    : own.factor_sparse();
}

bool Preconditioner::factor(const Slopes& by_P, const Slopes& by_H) {
  Implementation& own = *implementation_;
  return own.line() ? own.factor_dense(by_P, by_H) : own.factor_sparse();
}

void Preconditioner::solve(std::span<double> v) {
  Implementation& own = *implementation_;
  const bool touching = own.equations.touching();
  if (own.line() && touching) return own.touching_line_factors.solve(v);
  if (own.line()) return own.single ? own.line_factors_single.solve(v) : own.line_factors.solve(v);
  for (Eigen::Index k = 0; k < own.size(); ++k) own.rhs[k] = v[own.node(k)];
  if (touching) own.subtract_known_film(v);
  own.solution = own.lu.solve(own.rhs);
  double load = own.load_row.dot(own.solution);
  own.for_touching([&](std::size_t node, std::size_t k) { load += own.load_of(node) * v[k]; });
  const double dH00 = (load - v.back()) / own.schur;
  for (Eigen::Index k = 0; k < own.size(); ++k) v[own.node(k)] = own.solution[k] - dH00 * own.border[k];
  if (touching) own.solve_touching(dH00, v);
  v.back() = dH00;
}

void Preconditioner::solve_transposed(std::span<double> v) {
  Implementation& own = *implementation_;
  if (own.line())
    return own.single ? own.line_factors_single.solve_transposed(v) : own.line_factors.solve_transposed(v);
  for (Eigen::Index k = 0; k < own.size(); ++k) own.rhs[k] = v[own.node(k)];
  const double load = (own.border.dot(own.rhs) - v.back()) / own.schur;
  own.rhs -= load * own.load_row;
  own.solution = own.lu.transpose().solve(own.rhs);
  for (Eigen::Index k = 0; k < own.size(); ++k) v[own.node(k)] = own.solution[k];
  v.back() = load;
}

}  // namespace ehl::newton
