#include "line_solvers/decimation.hpp"

namespace ehl::line_solvers {

template <int reach>
Decimation<reach>::Decimation(int points) : points_(points) {
  const int blocks = (points + width - 1) / width;
  for (int count = blocks;; count = (count + 1) / 2) {
    const auto n = static_cast<std::size_t>(count);
    Level level;
    level.left.resize(n);
    level.middle.resize(n);
    level.right.resize(n);
    level.rhs.resize(n);
    level.x.resize(n);
    levels_.push_back(std::move(level));
    if (count == 1) break;
  }
  // Rows after the last point give delta = 0.
  for (int i = points + 1; i <= blocks * width; ++i) {
    Row identity{};
    identity.a[Row::lower] = core::broadcast(1.0);
    set(i, identity);
  }
}

template <int reach>
void Decimation<reach>::set(int i, const Row& row) {
  Level& level = levels_[0];
  const auto b = static_cast<std::size_t>((i - 1) / width);
  const auto r = static_cast<std::size_t>((i - 1) % width);
  for (std::size_t c = 0; c < static_cast<std::size_t>(width); ++c) {
    const auto at = [&](int column_of_block) {
      const int q = column_of_block + static_cast<int>(c) - static_cast<int>(r);
      return q < -Row::lower || q > Row::upper ? Lanes{} : row.a[static_cast<std::size_t>(q + Row::lower)];
    };
    level.left[b][r][c] = b == 0 ? Lanes{} : at(-width);
    level.middle[b][r][c] = at(0);
    level.right[b][r][c] = b + 1 == level.middle.size() ? Lanes{} : at(width);
  }
  level.rhs[b][r] = row.rhs;
}

template <int reach>
void Decimation<reach>::multiply_subtract(const Matrix& a, const Matrix& b, Matrix& c) {
  for (std::size_t r = 0; r < a.size(); ++r)
    for (std::size_t k = 0; k < a.size(); ++k)
      for (std::size_t s = 0; s < a.size(); ++s) c[r][s] -= a[r][k] * b[k][s];
}

template <int reach>
void Decimation<reach>::multiply_subtract(const Matrix& a, const Vector& b, Vector& c) {
  for (std::size_t r = 0; r < a.size(); ++r)
    for (std::size_t k = 0; k < a.size(); ++k) c[r] -= a[r][k] * b[k];
}

template <int reach>
void Decimation<reach>::divide_by_middle(Level& level, std::size_t b, int points_per_block, SmallPivot& small) {
  constexpr auto m = static_cast<std::size_t>(width);
  Matrix& a = level.middle[b];
  for (std::size_t k = 0; k < m; ++k) {
    Lanes largest{};
    for (std::size_t s = 0; s < m; ++s) largest = core::max(largest, core::abs(a[k][s]));
    const core::LaneMask fine = core::abs(a[k][k]) > largest * smallest_pivot;
    if (!core::all(fine) && small.point < 0)
      for (int lane = 0; lane < core::lanes && small.point < 0; ++lane)
        if (!fine[lane])
          small = {static_cast<int>(b) * points_per_block + static_cast<int>(k) + 1, lane, a[k][k][lane]};
    const Lanes inverse = 1.0 / a[k][k];
    for (std::size_t s = k + 1; s < m; ++s) a[k][s] *= inverse;
    for (std::size_t s = 0; s < m; ++s) {
      level.left[b][k][s] *= inverse;
      level.right[b][k][s] *= inverse;
    }
    level.rhs[b][k] *= inverse;
    for (std::size_t r = 0; r < m; ++r) {  // Gauss-Jordan: rows above and below
      if (r == k) continue;
      const Lanes f = a[r][k];
      for (std::size_t s = k + 1; s < m; ++s) a[r][s] -= f * a[k][s];
      for (std::size_t s = 0; s < m; ++s) {
        level.left[b][r][s] -= f * level.left[b][k][s];
        level.right[b][r][s] -= f * level.right[b][k][s];
      }
      level.rhs[b][r] -= f * level.rhs[b][k];
    }
  }
}

// Eliminates the blocks 1, 3, 5, ..; the remaining system couples the blocks 0, 2, 4, ..
template <int reach>
void Decimation<reach>::reduce(Level& fine, Level& coarse, int points_per_block, SmallPivot& small) {
  const std::size_t n = fine.middle.size();
  for (std::size_t b = 1; b < n; b += 2) divide_by_middle(fine, b, points_per_block, small);
  for (std::size_t b = 0; b < n; b += 2) {
    const std::size_t half = b / 2;
    coarse.left[half] = Matrix{};
    coarse.right[half] = Matrix{};
    coarse.middle[half] = fine.middle[b];
    coarse.rhs[half] = fine.rhs[b];
    if (b > 0) {
      multiply_subtract(fine.left[b], fine.left[b - 1], coarse.left[half]);
      multiply_subtract(fine.left[b], fine.right[b - 1], coarse.middle[half]);
      multiply_subtract(fine.left[b], fine.rhs[b - 1], coarse.rhs[half]);
    }
    if (b + 1 < n) {
      multiply_subtract(fine.right[b], fine.left[b + 1], coarse.middle[half]);
      multiply_subtract(fine.right[b], fine.right[b + 1], coarse.right[half]);
      multiply_subtract(fine.right[b], fine.rhs[b + 1], coarse.rhs[half]);
    }
  }
}

template <int reach>
void Decimation<reach>::expand(Level& fine, const Level& coarse) {
  const std::size_t n = fine.middle.size();
  for (std::size_t b = 0; b < n; b += 2) fine.x[b] = coarse.x[b / 2];
  for (std::size_t b = 1; b < n; b += 2) {
    Vector x = fine.rhs[b];
    multiply_subtract(fine.left[b], fine.x[b - 1], x);
    if (b + 1 < n) multiply_subtract(fine.right[b], fine.x[b + 1], x);
    fine.x[b] = x;
  }
}

template <int reach>
SmallPivot Decimation<reach>::solve() {
  SmallPivot small;
  int points_per_block = width;
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l, points_per_block *= 2)
    reduce(levels_[l], levels_[l + 1], points_per_block, small);
  Level& last = levels_.back();
  divide_by_middle(last, 0, points_per_block, small);
  last.x[0] = last.rhs[0];
  for (std::size_t l = levels_.size() - 1; l > 0; --l) expand(levels_[l - 1], levels_[l]);
  return small;
}

template class Decimation<1>;
template class Decimation<2>;
template class Decimation<3>;

}  // namespace ehl::line_solvers
