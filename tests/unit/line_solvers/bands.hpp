#pragma once
// Band systems of a batch of lines for the tests, and both ways to solve them.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "line_solvers/decimation.hpp"
#include "line_solvers/elimination.hpp"
#include "line_solvers/two_ended.hpp"
#include "support/random.hpp"

namespace ehl::tests {

using core::Lanes;
using core::lanes;

/// Rows 1..points are entries 1..points, as in the solvers. Columns outside the line contain numbers
/// that must have no effect.
template <int reach>
using Band = std::vector<line_solvers::BandRow<reach>>;

inline int points_of(std::size_t entries) { return static_cast<int>(entries) - 1; }

/// The delta of every point: entry i holds all lines of the batch.
using Deltas = std::vector<Lanes>;

struct Solved {
  Deltas delta;
  line_solvers::SmallPivot small;
};

template <int reach>
Solved eliminate(const Band<reach>& band) {
  std::vector<typename line_solvers::Elimination<reach>::Factors> work(band.size());
  line_solvers::Elimination<reach> elimination(work.data());
  for (std::size_t i = 1; i < band.size(); ++i) elimination.push(band[i]);
  Solved solved{Deltas(band.size()), elimination.small_pivot()};
  elimination.back_substitute([&](int i, Lanes delta) { solved.delta[static_cast<std::size_t>(i)] = delta; });
  return solved;
}

/// Solves each line from both ends, with the given number of rows from the first end.
template <int reach>
Solved eliminate_from_both_ends(const Band<reach>& band, int from_first) {
  using TwoEnded = line_solvers::TwoEnded<reach>;
  const int points = points_of(band.size());
  Solved solved{Deltas(band.size()), {}};
  std::vector<typename TwoEnded::Factors> work(band.size());
  for (int lane = 0; lane < lanes; ++lane) {
    const auto row_of = [&](int i) {
      typename TwoEnded::Row row{};
      for (std::size_t q = 0; q < row.a.size(); ++q) row.a[q] = band[static_cast<std::size_t>(i)].a[q][lane];
      row.rhs = band[static_cast<std::size_t>(i)].rhs[lane];
      return row;
    };
    TwoEnded elimination(work.data(), points);
    for (int i = 1; i <= from_first; ++i) elimination.push_first(row_of(i));
    for (int i = points; i > from_first; --i) elimination.push_last(row_of(i));
    elimination.substitute([&](int i, double delta) { solved.delta[static_cast<std::size_t>(i)][lane] = delta; });
    const line_solvers::SmallPivot small = elimination.small_pivot();
    if (small.point >= 0 && solved.small.point < 0) solved.small = {small.point, lane, small.pivot};
  }
  return solved;
}

template <int reach>
Solved decimate(const Band<reach>& band, line_solvers::Decimation<reach>& decimation) {
  for (std::size_t i = 1; i < band.size(); ++i) decimation.set(static_cast<int>(i), band[i]);
  Solved solved{Deltas(band.size()), decimation.solve()};
  for (std::size_t i = 1; i < band.size(); ++i) solved.delta[i] = decimation.delta(static_cast<int>(i));
  return solved;
}
template <int reach>
Solved decimate(const Band<reach>& band) {
  line_solvers::Decimation<reach> decimation(points_of(band.size()));
  return decimate(band, decimation);
}

/// Random coefficients, different for each line; the diagonal is 0.7 to 1.3 times the sum of the
/// others, with either sign.
template <int reach>
Band<reach> random_band(int points, Random& random) {
  using Row = line_solvers::BandRow<reach>;
  Band<reach> band(static_cast<std::size_t>(points) + 1);
  for (std::size_t i = 1; i < band.size(); ++i)
    for (int lane = 0; lane < lanes; ++lane) {
      double others = 0.0;
      for (Lanes& a : band[i].a) {
        a[lane] = random.between(-1.0, 1.0);
        others += std::abs(a[lane]);
      }
      const double sign = random.chance(0.5) ? 1.0 : -1.0;
      band[i].a[Row::lower][lane] = sign * random.between(0.7, 1.3) * others;
      band[i].rhs[lane] = random.between(-1.0, 1.0);
    }
  return band;
}

/// The matrix of one line.
template <int reach>
Eigen::MatrixXd matrix_of(const Band<reach>& band, int lane) {
  using Row = line_solvers::BandRow<reach>;
  const int points = points_of(band.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(points, points);
  for (int i = 1; i <= points; ++i)
    for (int q = -Row::lower; q <= Row::upper; ++q)
      if (i + q >= 1 && i + q <= points)
        A(i - 1, i + q - 1) = band[static_cast<std::size_t>(i)].a[static_cast<std::size_t>(q + Row::lower)][lane];
  return A;
}

/// The largest difference between a dense solution of every line (column = lane) and deltas,
/// relative to the largest value.
inline double difference(const Eigen::MatrixXd& truth, const Deltas& delta) {
  double largest = 0.0;
  for (int lane = 0; lane < lanes; ++lane)
    for (int i = 1; i <= truth.rows(); ++i) {
      const double error = std::abs(delta[static_cast<std::size_t>(i)][lane] - truth(i - 1, lane));
      largest = error <= largest ? largest : error;  // a NaN is kept
    }
  return largest / truth.cwiseAbs().maxCoeff();
}

}  // namespace ehl::tests
