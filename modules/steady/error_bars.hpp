#pragma once
// Estimated errors of the results, split into their parts.
#include <vector>

#include "core/constants.hpp"

namespace ehl::steady {

struct Scene;
struct Solution;

/// Parts of a relative error, each an estimate; NaN if unknown.
struct ErrorBar {
  /// The part of the mesh (error_estimate.hpp), from the grid sequence; rough with one grid.
  double discretization = core::unknown;
  double algebraic = core::unknown;  ///< what further cycles would change (judgement/stopping.hpp)
  /// The error on this domain: the sum of both.
  double total() const { return discretization + algebraic; }
};

/// A value with its relative error, the algebraic part included.
struct Estimate {
  double value = core::unknown;
  double error = core::unknown;
};

struct ErrorBars {
  ErrorBar Hc{};
  ErrorBar Hm{};         ///< of the smallest nodal value: the error of Hm_fitted plus the difference of the two
  ErrorBar Hm_fitted{};  ///< of Hm_fitted_value
  double Hm_fitted_value = core::unknown;  ///< minimum between the nodes (fitted_minimum.hpp), and its place
  double Hm_fitted_X = core::unknown;
  double Hm_fitted_Y = core::unknown;
  Estimate Hc_extrapolated{};  ///< extrapolated from the grid sequence to mesh size zero, on this domain
  Estimate Hm_extrapolated{};  ///< from Hm_fitted
  /// The best estimate, which is reported first: the extrapolated value or that of the finest grid (for Hm the fitted
  /// one), whichever has the smaller error. Known for adjoint error estimates and for line contacts.
  Estimate Hc_best{};
  Estimate Hm_best{};
  /// Relative change of Hc or Hm on an infinite domain; 0 if a meniscus ends the inlet. With the far field in closed
  /// form it is the adjoint estimate of the boundary pressure (adjoint/errors.hpp), for a line contact a multiple of
  /// the rough estimate. Otherwise, for Hc, it is Solution::domain_error_Hc or the rough estimate, right within a
  /// factor of about 2 (domain_error.hpp). Not part of total().
  double domain = core::unknown;
  /// Relative errors of the numbers of the scene's observer; NaN where the levels give no estimate.
  std::vector<double> observed{};
  double P_max = core::unknown;  ///< relative error estimate of P_max; NaN if it does not converge
  /// True if the differences of P_max between the levels fall and no spike is about to exceed it. At a spike that no
  /// grid resolves they grow, and P_max depends on the mesh.
  bool P_max_converging = false;
  /// True if no spike is visible but the oil at the rim is so viscous that a finer grid may show one.
  bool spike_unseen = false;
  /// Share of the variance of rough surfaces that half as many cells lose; set if it is so large that P_max has no
  /// error.
  double relief_unresolved = 0.0;
  /// True if P_max has no error; with fewer than three levels, if a spike is visible or may be hidden.
  bool spike_unresolved = false;
};

/// in: a solution whose levels, verification and domain_error_Hc are complete.
ErrorBars error_bars_of(const Scene& scene, const Solution& solution);

}  // namespace ehl::steady
