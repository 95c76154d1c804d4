#pragma once
// The discretization error of a film thickness from the sequence of levels.
#include <limits>
#include <span>

namespace ehl::judgement {

struct ErrorEstimate {
  double relative_error = 0.0;  ///< |error of the last value / last value|; NaN with fewer than two values
  double order = 0.0;           ///< observed order; NaN with fewer than three values or where it has no meaning
};

/// Error of the last of several values, each from a grid of half the mesh size of the one before:
///   order p = log2((v_{k-1} - v_{k-2}) / (v_k - v_{k-1})),   error = s |v_k - v_{k-1}| / (2^p - 1).
/// p is held between half the scheme's order and the scheme's order: a sequence that is not yet asymptotic, or whose
/// differences change their sign, must not promise more than the scheme can give. With two values p is the scheme's
/// order. A change that is less than 2^-(scheme's order + 1) of the one before counts as that much: differences that
/// are about to change their sign are small by accident, and say nothing of the error. s is the safety factor, 1.25 for
/// three values or more and 1.5 for two: the README of this module says what it was measured on. Never below `least`.
ErrorEstimate estimate_error(std::span<const double> values, double scheme_order, double least = 0.0);

/// Relative error below which the first-order wedge does not promise to be, 0.35 h/Hm^(2/3). Hm^(2/3) is the width of
/// the zones in which the film is made (resolution.hpp); the error of Hc and Hm is 0.15 to 0.42 times h over it, with a
/// second-order part of the other sign that hides it from the differences of coarse grids.
/// in: h mesh size, Hm > 0 smallest film there. out: infinite for a film that is not positive.
double first_order_floor(double h, double Hm);

/// Relative error below which upstream3 does not promise to be, in units of (h/Hm^(2/3))^2: its errors of Hm change
/// their sign from grid to grid, and the sequence may tell none. measured: bench_coverage's contacts on 128 to 512
/// cells. The errors of the fitted Hm are 0.002 to 0.17, 0.05 in the median, of Hc 0.001 to 0.03 and above only where
/// the sequence tells them.
inline constexpr double third_order_floor_of_Hc = 0.01;
inline constexpr double third_order_floor_of_Hm = 0.15;
double third_order_floor(double h, double Hm, double share);

/// Relative error of Hc and Hm on a grid that has none to be compared with, from the width of the zones in which the
/// film is made: with s = h/Hm^(2/3), 0.85 s^2 for the second-order wedge and 0.35 s max(1, s) for the first-order one.
/// in: as above. out: infinite for a film that is not positive. A rough bound: on 64 cells nine of ten errors are below
/// it, half of them by more than a factor of 2.
double error_of_one_grid(double h, double Hm, double scheme_order);

/// Relative errors of the last Hc and Hm, Hm between the nodes, where the inlet's meniscus lies anywhere in its cells
/// on each level and the changes swing: of Hm the last change, or half of the one before, and what `safety` asks of the
/// last change of Hc at order 2, with a fifth of Hm's. measured: r = 0.2 to 1.8 on 128 to 512 cells against 1024,
/// 40 contacts for the rule and 16 others with it (tests/bench/starved_bars.csv).
/// in: both of the same length. out: NaN with fewer than two values.
struct FilmErrors {
  double Hc = 0.0, Hm = 0.0;
};
FilmErrors errors_beside_meniscus(std::span<const double> Hc, std::span<const double> Hm);

struct Extrapolation {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double value = unknown;
  double relative_error = unknown;
};

/// Of what an extrapolation adds, the share that is never trusted: for Hc, whose order comes out within a few
/// hundredths, and for the fitted minimum, part of whose error depends on where between the nodes the minimum lies.
inline constexpr double unsure_of_Hc = 0.05;
inline constexpr double unsure_of_Hm = 0.2;

/// Richardson's v_k + (v_k - v_{k-1})/(2^p - 1), p the scheme's order; its error from what it changed since the
/// extrapolation one level below, and at least the share `unsure` of what was added. NaN with fewer than three values,
/// and where that error is as large as the value, or the value of the other sign: the levels then tell none.
Extrapolation extrapolate(std::span<const double> values, double scheme_order, double unsure);

}  // namespace ehl::judgement
