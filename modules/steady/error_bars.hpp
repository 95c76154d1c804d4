#pragma once
// How far the numbers of a solution are from those of the equations, part by part.
#include <limits>

namespace ehl::steady {

struct Scene;
struct Solution;

/// Parts of a relative error, each an estimate; NaN where unknown.
struct ErrorBar {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double discretization = unknown;  ///< of the mesh (error_estimate.hpp): from the levels; rough where there is one
  double algebraic = unknown;       ///< what further cycles would change (checks.hpp)
  /// The error on this domain: the sum of both.
  double total() const { return discretization + algebraic; }
};

/// A value with its error: relative, the cycles' part included.
struct Estimate {
  double value = ErrorBar::unknown;
  double error = ErrorBar::unknown;
};

struct ErrorBars {
  ErrorBar Hc{};
  ErrorBar Hm{};         ///< of the smallest node: that of Hm_fitted, and how far the node is from the minimum
  ErrorBar Hm_fitted{};  ///< of Hm_fitted_value
  double Hm_fitted_value = ErrorBar::unknown;  ///< minimum between the nodes (fitted_minimum.hpp), and where it is
  double Hm_fitted_X = ErrorBar::unknown;
  double Hm_fitted_Y = ErrorBar::unknown;
  Estimate Hc_extrapolated{};  ///< from the levels to a mesh of size zero on this domain
  Estimate Hm_extrapolated{};  ///< from Hm_fitted
  /// Extrapolated or of the finest grid (of Hm the fitted one), whichever has the narrower bar: what is shown first.
  /// Where the errors are by the weights, or of a line contact, whose bars earn it; else unknown.
  Estimate Hc_best{};
  Estimate Hm_best{};
  /// Relative change of Hc or Hm for a domain without end; 0 where a meniscus ends the inlet. With the far field in
  /// closed form: by the weights of the pressure on the boundary (adjoint/errors.hpp), of a line three times the rough
  /// estimate. Else of Hc: Solution::domain_error_Hc where that is known, or the rough estimate, right within a factor
  /// of about 2 (domain_error.hpp). No part of total().
  double domain = ErrorBar::unknown;
  double P_max = ErrorBar::unknown;  ///< relative error estimate of P_max; NaN where it does not converge
  /// Differences of P_max between the levels fall, and no spike is about to overtake it. At a spike that no grid
  /// resolves they grow: P_max then is a number of the mesh.
  bool P_max_converging = false;
  /// Or no spike is seen where the oil is as good as solid at the rim: a finer grid may show one.
  bool spike_unseen = false;
  /// Share of the variance of rough surfaces that half as many cells lose, where it is so much that P_max has no error.
  double relief_unresolved = 0.0;
  /// P_max has no error; or with less than three levels, which tell none, a spike is seen or may be unseen.
  bool spike_unresolved = false;
};

/// in: a solution whose levels, verification and domain_error_Hc are complete.
ErrorBars error_bars_of(const Scene& scene, const Solution& solution);

}  // namespace ehl::steady
