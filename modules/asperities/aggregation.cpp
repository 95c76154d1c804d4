#include "asperities/aggregation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ehl::asperities {
namespace {

using Vector = std::vector<double>;

constexpr int coarsest_rows = 64;     // where Gauss-Seidel sweeps solve the rest
constexpr int coarsest_sweeps = 40;   // there
constexpr double strong = 0.25;       // least share of a node's strongest conductance that makes a pair
constexpr double fast_enough = 0.25;  // reduction by the first inner step that makes the second one unnecessary

std::size_t index(int n) { return static_cast<std::size_t>(n); }

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
  return sum;
}

double row_sum(const Network& A, int i, const Vector& x) {
  double sum = 0.0;
  for (std::size_t k = A.first[index(i)]; k < A.first[index(i) + 1]; ++k)
    sum += A.conductance[k] * x[index(A.column[k])];
  return sum;
}

void multiply(const Network& A, const Vector& x, Vector& y) {
  for (int i = 0; i < A.rows(); ++i) y[index(i)] = A.diagonal[index(i)] * x[index(i)] - row_sum(A, i, x);
}

void forward_sweep(const Network& A, const Vector& b, Vector& x) {
  for (int i = 0; i < A.rows(); ++i) x[index(i)] = (b[index(i)] + row_sum(A, i, x)) / A.diagonal[index(i)];
}
void backward_sweep(const Network& A, const Vector& b, Vector& x) {
  for (int i = A.rows(); i-- > 0;) x[index(i)] = (b[index(i)] + row_sum(A, i, x)) / A.diagonal[index(i)];
}

// The number of the pair of each node. A node joins the free neighbour with the largest conductance, if that is strong;
// without one it joins the pair of its strongest neighbour.
std::vector<int> pairs_of(const Network& A, int& count) {
  std::vector<int> pair(index(A.rows()), -1);
  count = 0;
  for (int i = 0; i < A.rows(); ++i) {
    if (pair[index(i)] >= 0) continue;
    int partner = -1, strongest = -1;
    double most_free = 0.0, most = 0.0;
    for (std::size_t k = A.first[index(i)]; k < A.first[index(i) + 1]; ++k) {
      const int j = A.column[k];
      const double c = A.conductance[k];
      if (c > most) {
        most = c;
        strongest = j;
      }
      if (pair[index(j)] < 0 && c > most_free) {
        most_free = c;
        partner = j;
      }
    }
    if (partner >= 0 && most_free >= strong * most) {
      pair[index(i)] = pair[index(partner)] = count++;
    } else if (strongest >= 0 && pair[index(strongest)] >= 0) {
      pair[index(i)] = pair[index(strongest)];
    } else {
      pair[index(i)] = count++;
    }
  }
  return pair;
}

// The network of the aggregates: conductances between two of them are added, those within one vanish.
Network joined(const Network& A, const std::vector<int>& part, int count) {
  Network coarse;
  coarse.diagonal.assign(index(count), 0.0);
  std::vector<std::vector<std::pair<int, double>>> rows(index(count));
  for (int i = 0; i < A.rows(); ++i) {
    const int I = part[index(i)];
    coarse.diagonal[index(I)] += A.diagonal[index(i)];
    for (std::size_t k = A.first[index(i)]; k < A.first[index(i) + 1]; ++k) {
      const int J = part[index(A.column[k])];
      if (J == I) {
        coarse.diagonal[index(I)] -= A.conductance[k];
        continue;
      }
      auto& row = rows[index(I)];
      const auto at = std::ranges::find(row, J, &std::pair<int, double>::first);
      if (at == row.end())
        row.emplace_back(J, A.conductance[k]);
      else
        at->second += A.conductance[k];
    }
  }
  coarse.first.push_back(0);
  for (int I = 0; I < count; ++I) {
    double sum = 0.0;
    for (const auto& [J, c] : rows[index(I)]) {
      coarse.column.push_back(J);
      coarse.conductance.push_back(c);
      sum += c;
    }
    // Rounding of the differences above must not make the network active.
    coarse.diagonal[index(I)] = std::max(coarse.diagonal[index(I)], sum);
    coarse.first.push_back(coarse.column.size());
  }
  return coarse;
}

// The networks from the finest to the coarsest, and the work space of each.
class Multigrid {
 public:
  explicit Multigrid(const Network& network) {
    levels_.push_back({.A = network});
    while (levels_.back().A.rows() > coarsest_rows) {
      int half = 0, quarter = 0;
      std::vector<int> part = pairs_of(levels_.back().A, half);
      const Network pairs = joined(levels_.back().A, part, half);
      const std::vector<int> of_pairs = pairs_of(pairs, quarter);
      for (int& one : part) one = of_pairs[index(one)];
      if (quarter >= levels_.back().A.rows()) break;
      levels_.back().part = std::move(part);
      levels_.push_back({.A = joined(pairs, of_pairs, quarter)});
    }
    for (Level& level : levels_)
      for (Vector* v : {&level.r, &level.b, &level.x, &level.z, &level.Az, &level.w, &level.Aw})
        v->assign(index(level.A.rows()), 0.0);
  }

  /// x = an approximation of the solution of A x = b on this level.
  void cycle(std::size_t l, const Vector& b, Vector& x);

 private:
  struct Level {
    Network A{};
    std::vector<int> part{};  // the node of the coarser level to which each node belongs
    Vector r{}, b{}, x{}, z{}, Az{}, w{}, Aw{};
  };
  void solve_coarse(std::size_t l);
  std::vector<Level> levels_{};
};

// x of level l from its b, by at most two steps of flexible conjugate gradients.
void Multigrid::solve_coarse(std::size_t l) {
  Level& level = levels_[l];
  if (l + 1 == levels_.size()) {
    cycle(l, level.b, level.x);
    return;
  }
  cycle(l, level.b, level.z);
  multiply(level.A, level.z, level.Az);
  const double zAz = dot(level.z, level.Az), zb = dot(level.z, level.b);
  std::ranges::fill(level.x, 0.0);
  if (!(zAz > 0.0)) return;
  const double before = dot(level.b, level.b);
  double after = 0.0;
  for (std::size_t n = 0; n < level.b.size(); ++n) {
    level.x[n] = zb / zAz * level.z[n];
    level.b[n] -= zb / zAz * level.Az[n];
    after += level.b[n] * level.b[n];
  }
  if (after <= fast_enough * fast_enough * before) return;
  cycle(l, level.b, level.w);
  multiply(level.A, level.w, level.Aw);
  const double across = dot(level.w, level.Az) / zAz;
  const double wAw = dot(level.w, level.Aw) - across * across * zAz, wb = dot(level.w, level.b);
  if (!(wAw > 0.0)) return;
  for (std::size_t n = 0; n < level.x.size(); ++n) level.x[n] += wb / wAw * (level.w[n] - across * level.z[n]);
}

void Multigrid::cycle(std::size_t l, const Vector& b, Vector& x) {
  Level& level = levels_[l];
  std::ranges::fill(x, 0.0);
  if (l + 1 == levels_.size()) {
    for (int sweep = 0; sweep < coarsest_sweeps; ++sweep) {
      forward_sweep(level.A, b, x);
      backward_sweep(level.A, b, x);
    }
    return;
  }
  forward_sweep(level.A, b, x);
  multiply(level.A, x, level.r);
  Level& coarse = levels_[l + 1];
  std::ranges::fill(coarse.b, 0.0);
  for (std::size_t n = 0; n < b.size(); ++n) coarse.b[index(level.part[n])] += b[n] - level.r[n];
  solve_coarse(l + 1);
  for (std::size_t n = 0; n < b.size(); ++n) x[n] += coarse.x[index(level.part[n])];
  backward_sweep(level.A, b, x);
}

}  // namespace

NetworkSolution solve(const Network& network, const std::vector<double>& b, double tolerance, int max_iterations) {
  Multigrid multigrid(network);
  NetworkSolution solution{.x = Vector(b.size(), 0.0)};
  Vector r = b, z(b.size()), direction(b.size(), 0.0), along(b.size(), 0.0);
  const double size = std::sqrt(dot(b, b));
  double curvature = 1.0;
  if (size == 0.0) return solution;
  for (solution.residual = 1.0; solution.iterations < max_iterations && solution.residual > tolerance;
       ++solution.iterations) {
    multigrid.cycle(0, r, z);
    const double back = dot(z, along) / curvature;
    for (std::size_t n = 0; n < z.size(); ++n) direction[n] = z[n] - back * direction[n];
    multiply(network, direction, along);
    curvature = dot(direction, along);
    if (!(curvature > 0.0)) break;
    const double length = dot(direction, r) / curvature;
    for (std::size_t n = 0; n < r.size(); ++n) {
      solution.x[n] += length * direction[n];
      r[n] -= length * along[n];
    }
    solution.residual = std::sqrt(dot(r, r)) / size;
  }
  return solution;
}

}  // namespace ehl::asperities
