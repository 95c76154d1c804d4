#pragma once
// Numbers of a rough surface that the models of asperities need.
#include <vector>

#include "asperities/cosine_transform.hpp"

namespace ehl::asperities {

struct RoughnessNumbers {
  double Sq = 0.0;       ///< root mean square height [m]
  double slope = 0.0;    ///< root mean square of the gradient, sqrt(<z_x^2 + z_y^2>)
  double share_x = 0.0;  ///< of the mean square slope's direction: mean of q_x^2/q^2 over the power spectrum; 0.5: none
  double correlation_x = 0.0, correlation_y = 0.0;  ///< where the autocorrelation falls to 0.5 [m]; NaN: nowhere
  double peklenik = 0.0;                            ///< correlation_x/correlation_y
  double oblique = 0.0;  ///< 2 <z_x z_y>/<z_x^2 + z_y^2>: 0 for a lay along an axis, 1 or -1 at 45 degrees
  double skewness = 0.0, kurtosis = 0.0;  ///< 0 and 3 of Gaussian heights
  double highest = 0.0;                   ///< highest point [m]
  /// Asperities with the same spectral moments, for the law of Greenwood and Williamson.
  double summit_sigma = 0.0;   ///< root mean square of the summits' heights [m]
  double summit_height = 0.0;  ///< their mean above the mean plane [m]
  double eta_beta_sigma = 0.0, sigma_over_beta = 0.0;
};

/// in: heights without a mean [m] at the points of the cell.
///
/// The asperities are those of a Gaussian, isotropic surface with the spectral moments m2 and m4, the mean square slope
/// and curvature of a profile (means of both axes, by differences of neighbours):
/// density eta = m4/(6 pi sqrt(3) m2), radius beta = (3/8) sqrt(pi/m4), and with alpha = m0 m4/m2^2 the summits' mean
/// height 4 sqrt(m0/(pi alpha)) and variance (1 - 0.8968/alpha) m0. source: McCool (1987), J. Tribol. 109, 264, after
/// Nayak (1971) and Bush, Gibson and Keogh (1976).
RoughnessNumbers roughness_numbers(const Cell& cell, const std::vector<double>& z);

/// Factor of the flow along x for roughness small against the gap h: 1 + 3 (Sq/h)^2 (1 - 3 share), share the mean of
/// q_x^2/q^2; isotropic: 1 - (3/2)(Sq/h)^2. From the conductivity k = h^3 (1 + 3 e + 3 e^2) of a gap h (1 + e), whose
/// mean flow is <k> - <dk^2 q_x^2/q^2>/<k> to second order. error: fourth order in Sq/h, third if heights are skewed.
double small_roughness_factor(double Sq_over_h, double share);

}  // namespace ehl::asperities
