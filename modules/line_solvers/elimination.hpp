#pragma once
// Gaussian elimination of the band, row by row: a row is assembled, eliminated and forgotten, so that only the upper
// factors of a batch of lines, three or four numbers per point, go to memory.
#include <array>

#include "line_solvers/line_system.hpp"

namespace ehl::line_solvers {

/// Eliminates the rows 1, 2, .. of the band as they come; delta is zero outside the line. No pivoting: the diagonal or
/// the film term dominates the rows of the relaxation. A small pivot is reported.
/// cost: lower (upper + 1) + 1 multiplications per point and line, and a division per point and batch.
template <int reach>
class Elimination {
  using Row = BandRow<reach>;

 public:
  /// Upper factors of one point: delta_i = g - sum u_q delta_{i+q}.
  struct Factors {
    std::array<Lanes, static_cast<std::size_t>(Row::upper)> u;
    Lanes g;
  };

  /// in: work, one entry per point, of which entries 1 .. are used; the caller owns it and reuses it from batch to
  /// batch.
  explicit Elimination(Factors* work) : factors_(work) {}

  /// Takes the next row: its point number must be one higher than the last.
  void push(Row row) {
    const int i = ++last_;
    // Columns i-lower .. i-1 are known in terms of later ones. Substituting the earliest first fills no new column.
    for (int q = Row::lower; q >= 1; --q) {
      if (i - q < 1) continue;
      const Factors& earlier = factors_[i - q];
      const Lanes m = row.a[static_cast<std::size_t>(Row::lower - q)];
      for (int t = 1; t <= Row::upper; ++t)
        row.a[static_cast<std::size_t>(Row::lower - q + t)] -= m * earlier.u[static_cast<std::size_t>(t - 1)];
      row.rhs -= m * earlier.g;
    }
    const Lanes pivot = row.a[Row::lower];
    check(pivot, row, i);
    const Lanes inverse = 1.0 / pivot;
    Factors& mine = factors_[i];
    for (int t = 1; t <= Row::upper; ++t)
      mine.u[static_cast<std::size_t>(t - 1)] = row.a[static_cast<std::size_t>(Row::lower + t)] * inverse;
    mine.g = row.rhs * inverse;
  }

  /// Back substitution from the last point: calls change(i, delta_i) for i = last .. 1.
  template <class Change>
  void back_substitute(Change change) const {
    std::array<Lanes, static_cast<std::size_t>(Row::upper)> later{};
    for (int i = last_; i >= 1; --i) {
      Lanes delta = factors_[i].g;
      for (std::size_t t = 0; t < later.size(); ++t) delta -= factors_[i].u[t] * later[t];
      change(i, delta);
      for (std::size_t t = later.size() - 1; t > 0; --t) later[t] = later[t - 1];
      later[0] = delta;
    }
  }

  const SmallPivot& small_pivot() const { return small_pivot_; }

 private:
  void check(Lanes pivot, const Row& row, int i) {
    Lanes largest{};
    for (const Lanes& a : row.a) largest = core::max(largest, core::abs(a));
    // Written so that NaN counts as small.
    const auto fine = core::abs(pivot) > largest * smallest_pivot;
    if (core::all(fine) || small_pivot_.point >= 0) return;
    for (int lane = 0; lane < core::lanes; ++lane)
      if (!fine[lane]) {
        small_pivot_ = {i, lane, pivot[lane]};
        return;
      }
  }

  Factors* factors_;
  int last_ = 0;
  SmallPivot small_pivot_;
};

}  // namespace ehl::line_solvers
