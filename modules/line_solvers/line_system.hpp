#pragma once
// The line system of the relaxation: two equations per point, with a batch of lines of constant Y in the lanes.
//
//   film      h_i - sum_|d|<=reach kappa_{i-d}(d) delta_{i-d} = 0
//             eqs. (12), (16), (22), (24)
//   Reynolds  sum_k a_ik delta_k - c_0 h_i - c_1 h_{i-1} - c_2 h_{i-2} - c_3 h_{i+1} = r_i
//             eqs. (13), (17), (23), (25)
//
// in residual form: h is the change of the film that the line takes into account, delta the change of the pressure, r
// the residual. kappa is K for a point that is changed singly and Delta K (eq. 14) for one whose change is distributed.
#include <array>

#include "core/simd.hpp"
#include "line_solvers/film_terms.hpp"

namespace ehl::line_solvers {

using core::Lanes;

/// The Reynolds equation of one point in every line of the batch.
template <std::size_t films>
struct PointEquation {
  std::array<Lanes, 5> a;      ///< coefficients of delta_{i-2} .. delta_{i+2}
  std::array<Lanes, films> c;  ///< coefficients of h_i, h_{i-1}, h_{i-2} and, if four, h_{i+1}
  Lanes r;                     ///< residual
};

/// One row of the band that remains after the film equation has eliminated every h. Columns i-lower .. i+upper of
/// delta; lower = reach + 2 is due to h_{i-2}. For a batch of lines, or for one line.
template <int reach, class Number = Lanes>
struct BandRow {
  static constexpr int lower = reach + 2;
  static constexpr int upper = reach > 2 ? reach : 2;
  static constexpr int width = lower + upper + 1;
  std::array<Number, width> a;
  Number rhs;
};

/// Eliminates the h of one point. It is exact, since the film equation gives every h explicitly, except that the
/// influence on h_{i+1} of changes beyond i + upper is dropped.
/// in: distributive(q), 1 where the change of point i + q is distributed and 0 where it is single, q = -lower .. upper.
template <int reach, std::size_t films, class Distributive>
inline BandRow<reach> eliminate_film(const FilmTerms& film, const PointEquation<films>& point,
                                     Distributive distributive) {
  using Row = BandRow<reach>;
  Row row;
  row.rhs = point.r;
  for (int q = -Row::lower; q <= Row::upper; ++q) {
    Lanes single{};
    Lanes saved{};  // reduction of the influence by distributing the change
    for (int m = 0; m < static_cast<int>(films); ++m) {
      const int column = m == 3 ? q - 1 : q + m;
      const int distance = column < 0 ? -column : column;
      if (distance > reach) continue;
      const auto d = static_cast<std::size_t>(distance);
      const auto h = static_cast<std::size_t>(m);
      single -= point.c[h] * film.K[d];
      saved -= point.c[h] * (film.K[d] - film.delta_K[d]);
    }
    Lanes& coefficient = row.a[static_cast<std::size_t>(q + Row::lower)];
    coefficient = single - distributive(q) * saved;
    if (q >= -2 && q <= 2) coefficient += point.a[static_cast<std::size_t>(q + 2)];
  }
  return row;
}
/// in: `distributive` points at the entry of point i in an array with one entry per point, readable from -lower to
/// upper.
template <int reach, std::size_t films>
inline BandRow<reach> eliminate_film(const FilmTerms& film, const PointEquation<films>& point,
                                     const Lanes* distributive) {
  return eliminate_film<reach>(film, point, [distributive](int q) { return distributive[q]; });
}

/// Turns a row into "delta_i = 0" in the lanes where `mask` is non-zero: cavitated points, or lanes after the last
/// line.
template <int reach>
inline void make_identity(BandRow<reach>& row, core::LaneMask mask) {
  for (std::size_t q = 0; q < row.a.size(); ++q) {
    const double diagonal = q == BandRow<reach>::lower ? 1.0 : 0.0;
    row.a[q] = mask ? core::broadcast(diagonal) : row.a[q];
  }
  row.rhs = mask ? Lanes{} : row.rhs;
}

/// A pivot below this share of the largest coefficient of its row counts as zero: the solution would have no digits
/// left.
inline constexpr double smallest_pivot = 1e-13;

}  // namespace ehl::line_solvers
