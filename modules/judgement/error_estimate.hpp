#pragma once
// The discretization error of a film thickness, estimated from the sequence of grids.
#include <optional>
#include <span>

#include "core/constants.hpp"
#include "judgement/tuning.hpp"

namespace ehl::judgement {

struct ErrorEstimate {
  double relative_error = 0.0;  ///< |error of the last value / last value|; NaN with fewer than two values
  double order = 0.0;           ///< observed order; NaN with fewer than three values or if it has no meaning
};

/// Error of the last of several values, each from a grid with half the mesh size of the one before:
///   order p = log2((v_{k-1} - v_{k-2}) / (v_k - v_{k-1})),   error = s |v_k - v_{k-1}| / (2^p - 1).
/// p is kept between half the scheme's order and the scheme's order, because a sequence that is not yet asymptotic, or
/// whose differences change sign, must not promise more than the scheme can give. With two values p is the scheme's
/// order.
/// The last change counts as at least 2^-(scheme's order + 1) of the one before: differences that are about to change
/// sign are small by accident. Errors of opposite sign cancel in a change that is smaller by another factor of 2^1.5;
/// then the change counts as 2^-(scheme's order) of the one before, and p is half the scheme's order. s is the safety
/// factor, 1.25 for three values or more and 1.5 for two. [bench: safety]
/// in: slowest_order replaces half the scheme's order as the lower bound of an observed order.
/// out: never below `least`.
ErrorEstimate estimate_error(const Tuning& tuning, std::span<const double> values, double scheme_order,
                             double least = 0.0, std::optional<double> slowest_order = {});

/// Lower bound on the relative error of the first-order wedge, 0.35 h/Hm^(2/3), where Hm^(2/3) is the width of the
/// zones in which the film forms (steady/scales.hpp). A second-order part of opposite sign may hide that error from
/// the differences of coarse grids. [bench: first_order_share]
/// in: h mesh size, Hm > 0 minimum film there. out: infinite for a film that is not positive.
double first_order_floor(const Tuning& tuning, double h, double Hm);

/// Lower bounds on the relative errors of upstream3, in units of (h/Hm^(2/3))^2. The errors of Hm change sign from grid
/// to grid, so that the grid sequence may show none. [bench: third_order_floor]
/// in: share, Tuning::third_order_floor_of_Hc or third_order_floor_of_Hm.
double third_order_floor(double h, double Hm, double share);

/// Rough bound on the relative error of Hc and Hm on a single grid. With s = h/Hm^(2/3) it is 0.85 s^2 for the
/// second-order wedge and 0.35 s max(1, s) for the first-order one. [bench: error_of_one_grid]
/// in: as above. out: infinite for a film that is not positive.
double error_of_one_grid(const Tuning& tuning, double h, double Hm, double scheme_order);

/// Relative errors of the last Hc and Hm (Hm between the nodes) with a meniscus at the inlet. Its place within a cell
/// differs from level to level, so that the changes alternate. Hm: the last change, or half of the one before. Hc: the
/// safety factor times a third of the last change, plus a fifth of the error of Hm. [bench: starved_bars]
/// in: both of the same length. out: NaN with fewer than two values.
struct FilmErrors {
  double Hc = 0.0, Hm = 0.0;
};
FilmErrors errors_beside_meniscus(const Tuning& tuning, std::span<const double> Hc, std::span<const double> Hm);

struct Extrapolation {
  double value = core::unknown;
  double relative_error = core::unknown;
};

/// Richardson extrapolation v_k + (v_k - v_{k-1})/(2^p - 1), where p is the scheme's order. Its error is the change
/// since the extrapolation one level below, but at least the share `unsure` of the correction: Tuning::unsure_of_Hc or
/// unsure_of_Hm. (The order of Hc is observed reliably; part of the error of the fitted minimum depends on where
/// between the nodes the minimum lies.) out: NaN with fewer than three values, if that error is as large as the value,
/// or if the extrapolated value has the other sign.
Extrapolation extrapolate(std::span<const double> values, double scheme_order, double unsure);

}  // namespace ehl::judgement
