#pragma once
// The line system of the relaxation: two equations per point, a batch of lines of constant Y side by side in the lanes.
//
//   film      h_i - sum_|d|<=reach kappa_{i-d}(d) delta_{i-d} = 0      eqs. (12), (16), (22), (24)
//   Reynolds  sum_k a_ik delta_k - c_0 h_i - c_1 h_{i-1} - c_2 h_{i-2} - c_3 h_{i+1} = r_i   eqs. (13), (17), (23),
//   (25)
//
// in residual form: h is the change of the film that the line sees, delta the change of the pressure, r the residual.
// kappa is K for a point that is changed alone and Delta K (eq. 14) for one whose change is distributed.
#include <array>

#include "core/simd.hpp"
#include "line_solvers/film_terms.hpp"

namespace ehl::line_solvers {

using core::Lanes;

/// The Reynolds equation of one point in every line of the batch.
template <std::size_t films>
struct PointEquation {
  std::array<Lanes, 5> a;      ///< coefficients of delta_{i-2} .. delta_{i+2}
  std::array<Lanes, films> c;  ///< coefficients of h_i, h_{i-1}, h_{i-2} and, of four, h_{i+1}
  Lanes r;                     ///< residual
};

/// One row of the band that is left when the film equation has been used to eliminate every h.
/// Columns i-lower .. i+upper of delta; lower = reach + 2 comes from h_{i-2}. Of a batch of lines, or of one.
template <int reach, class Number = Lanes>
struct BandRow {
  static constexpr int lower = reach + 2;
  static constexpr int upper = reach > 2 ? reach : 2;
  static constexpr int width = lower + upper + 1;
  std::array<Number, width> a;
  Number rhs;
};

/// Eliminates the h of one point: exact, as the film equation gives every h explicitly, but that what delta behind
/// i + upper does to h_{i+1} is left out.
/// in: distributive(q), 1 where the change of point i + q is distributed and 0 where it is single, q = -lower .. upper.
template <int reach, std::size_t films, class Distributive>
inline BandRow<reach> eliminate_film(const FilmTerms& film, const PointEquation<films>& point,
                                     Distributive distributive) {
  using Row = BandRow<reach>;
  Row row;
  row.rhs = point.r;
  for (int q = -Row::lower; q <= Row::upper; ++q) {
    Lanes single{};
    Lanes saved{};  // what distributing the change takes away from the influence
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
/// in: `distributive` points at the entry of point i of an array with one entry per point, readable likewise.
template <int reach, std::size_t films>
inline BandRow<reach> eliminate_film(const FilmTerms& film, const PointEquation<films>& point,
                                     const Lanes* distributive) {
  return eliminate_film<reach>(film, point, [distributive](int q) { return distributive[q]; });
}

/// Turns a row into "delta_i = 0" in the lanes where `mask` is non-zero: a cavitated point, or a lane behind the last
/// line.
template <int reach>
inline void make_identity(BandRow<reach>& row, core::LaneMask mask) {
  for (std::size_t q = 0; q < row.a.size(); ++q) {
    const double diagonal = q == BandRow<reach>::lower ? 1.0 : 0.0;
    row.a[q] = mask ? core::broadcast(diagonal) : row.a[q];
  }
  row.rhs = mask ? Lanes{} : row.rhs;
}

/// A pivot below this share of its row's largest coefficient counts as zero: nothing of the solution would be left.
inline constexpr double smallest_pivot = 1e-13;

}  // namespace ehl::line_solvers
