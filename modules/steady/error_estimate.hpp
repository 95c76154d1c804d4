#pragma once
// The discretization error of a film thickness from the sequence of levels.
#include <span>

namespace ehl::steady {

struct ErrorEstimate {
  double relative_error = 0.0;  ///< |error of the last value / last value|; NaN with fewer than two values
  double order = 0.0;           ///< observed order; NaN with fewer than three values or where it has no meaning
};

/// Error of the last of several values, each from a grid of half the mesh size of the one before:
///   order p = log2((v_{k-1} - v_{k-2}) / (v_k - v_{k-1})),   error = |v_k - v_{k-1}| / (2^p - 1).
/// p is held between 1/2 and the scheme's order: a sequence that is not yet asymptotic, or whose differences change
/// their sign, must not promise more than the scheme can give. With two values p is the scheme's order less 1/2.
ErrorEstimate estimate_error(std::span<const double> values, double scheme_order);

}  // namespace ehl::steady
