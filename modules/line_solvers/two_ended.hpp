#pragma once
// Gaussian elimination of the band of one line, from both ends at once. Each row waits for the pivot of the one before;
// two independent chains of rows overlap and take about half the time of one.
#include <algorithm>
#include <array>

#include "line_solvers/line_system.hpp"

namespace ehl::line_solvers {

/// Some rows of a line, written as vectors of rows and read one by one.
template <int reach, int rows>
class RowBlock {
 public:
  /// Writes a vector of rows from k on.
  void put(int k, const BandRow<reach>& made) {
    const auto from = static_cast<std::size_t>(k);
    for (std::size_t q = 0; q < made.a.size(); ++q) core::store(&a_[q][from], made.a[q]);
    core::store(&rhs_[from], made.rhs);
  }
  BandRow<reach, double> row(int k) const {
    const auto at = static_cast<std::size_t>(k);
    BandRow<reach, double> one;
    for (std::size_t q = 0; q < one.a.size(); ++q) one.a[q] = a_[q][at];
    one.rhs = rhs_[at];
    return one;
  }

 private:
  std::array<std::array<double, rows>, BandRow<reach>::width> a_;
  std::array<double, rows> rhs_;
};

/// Eliminates rows 1, 2, .. of the band from the first end, and rows last, last - 1, .. from the last end, as they
/// come; delta is zero outside the line. No pivoting; a small pivot is reported, as by Elimination. cost: a division
/// per point, for which the next row of the same end waits.
template <int reach>
class TwoEnded {
 public:
  using Row = BandRow<reach, double>;

  /// Factors of one point: delta_i = g - sum u_q delta_{i+q}, or delta_{i-q} from the last end.
  struct Factors {
    std::array<double, Row::lower> u;
    double g;
  };

  /// in: work, one entry per point, of which entries 1 .. last are used; the caller owns it.
  TwoEnded(Factors* work, int last) : factors_(work), first_(0), last_(last + 1), end_(last) {}

  /// Eliminates the next row from the first end.
  void push_first(const Row& row) {
    ++first_;
    from_first_.push(row.a, row.rhs, {first_, 0, 0.0}, factors_[first_], small_pivot_);
  }
  /// Eliminates the next row from the last end.
  void push_last(const Row& row) {
    --last_;
    auto backwards = row.a;
    std::reverse(backwards.begin(), backwards.end());
    from_last_.push(backwards, row.rhs, {last_, 0, 0.0}, factors_[last_], small_pivot_);
  }

  /// Back substitution after all rows: calls change(i, delta_i) for every point, from the middle to both ends.
  template <class Change>
  void substitute(Change change) {
    // Where the ends meet, rows from the last end contain only points before them; these rows are eliminated from the
    // first end as well.
    for (int k = 0; k < Row::upper && last_ <= end_; ++k, ++last_) {
      const Factors& met = factors_[last_];
      Row row{};
      row.a[Row::lower] = 1.0;
      for (std::size_t q = 1; q <= Row::lower; ++q) row.a[Row::lower - q] = met.u[q - 1];
      row.rhs = met.g;
      push_first(row);
    }
    const int before = first_, behind = end_ - first_;
    std::array<double, Row::upper> later{};
    std::array<double, Row::lower> earlier{};
    const auto from_first = [&](int i) {
      const double delta = unknown(factors_[i], later);
      change(i, delta);
      return delta;
    };
    const auto from_last = [&](int i) { change(i, unknown(factors_[i], earlier)); };
    for (int k = 0; k < before && k < Row::lower; ++k) earlier[static_cast<std::size_t>(k)] = from_first(first_ - k);
    const int both = std::min(before - Row::lower, behind);
    for (int k = 0; k < both; ++k) {
      from_first(first_ - Row::lower - k);
      from_last(first_ + 1 + k);
    }
    for (int k = std::max(both, 0); k < before - Row::lower; ++k) from_first(first_ - Row::lower - k);
    for (int k = std::max(both, 0); k < behind; ++k) from_last(first_ + 1 + k);
  }

  const SmallPivot& small_pivot() const { return small_pivot_; }

 private:
  /// Rows in the order of one direction: `before` columns of points already known in terms of later ones, the point
  /// itself, `behind` columns of later points.
  template <int before, int behind>
  class Chain {
   public:
    void push(std::array<double, before + 1 + behind> a, double rhs, SmallPivot here, Factors& mine,
              SmallPivot& small) {
      // Substituting the earliest first fills no new column.
      for (std::size_t q = before; q >= 1; --q) {
        const auto& earlier = recent_[q - 1];
        const double m = a[before - q];
        for (std::size_t t = 1; t <= behind; ++t) a[before - q + t] -= m * earlier[t - 1];
        rhs -= m * earlier[behind];
      }
      here.pivot = a[before];
      double largest = 0.0;
      for (const double value : a) largest = core::max(largest, core::abs(value));
      // Written so that NaN counts as small.
      if (!(core::abs(here.pivot) > largest * smallest_pivot) && small.point < 0) small = here;
      const double inverse = 1.0 / here.pivot;
      for (std::size_t k = before - 1; k > 0; --k) recent_[k] = recent_[k - 1];
      for (std::size_t t = 0; t < behind; ++t) mine.u[t] = recent_[0][t] = a[before + 1 + t] * inverse;
      mine.g = recent_[0][behind] = rhs * inverse;
    }

   private:
    /// u and g of the last rows, the nearest first, so that the next row finds them early. Zero before the first row.
    std::array<std::array<double, behind + 1>, before> recent_{};
  };

  /// delta of a point from the known ones next to it, the nearest first. It becomes the nearest of them.
  template <std::size_t known>
  static double unknown(const Factors& factors, std::array<double, known>& beside) {
    double delta = factors.g;
    for (std::size_t t = known; t-- > 0;)
      delta -= factors.u[t] * beside[t];  // the nearest last, since it was computed last
    for (std::size_t t = known - 1; t > 0; --t) beside[t] = beside[t - 1];
    beside[0] = delta;
    return delta;
  }

  Factors* factors_;
  int first_, last_, end_;
  Chain<Row::lower, Row::upper> from_first_;
  Chain<Row::upper, Row::lower> from_last_;
  SmallPivot small_pivot_;
};

}  // namespace ehl::line_solvers
