#pragma once
// Flow factors of the averaged Reynolds equation: the mean flow through a rough gap over that through a smooth one.
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "asperities/gap_table.hpp"
#include "rheology/table.hpp"

namespace ehl::asperities {

/// The factors of Patir and Cheng for Gaussian heights. gamma (Peklenik) is the correlation length along the flow over
/// that across it: gamma > 1 for longitudinal lay, 1 for isotropic, < 1 for transverse. With l = h/sigma
///
///   phi_x = 1 - C exp(-r l) for gamma <= 1,  1 + C l^-r for gamma > 1;   phi_y(l, gamma) = phi_x(l, 1/gamma)
///   Phi_s = A1 l^a1 exp(-a2 l + a3 l^2) for l <= 5,  A2 exp(-l/4) above
///
/// The coefficients are given for gamma = 1/9, 1/6, 1/3, 1, 3, 6, 9. Between them the factors themselves are
/// interpolated linearly in ln gamma. Below the least l of the source (0.5 to 1) a factor keeps its value there.
/// source: Patir and Cheng (1978), J. Lubr. Technol. 100, 12; (1979), 101, 220.
struct PatirCheng {
  double gamma = 1.0;
};
inline constexpr double least_gamma = 1.0 / 9.0, greatest_gamma = 9.0;

/// "Peklenik's gamma must be from 1/9 to 9, ..."; empty if it is.
std::string wrong_gamma(double gamma);

/// phi_x and d phi_x/dl at l = h/sigma. limits: gamma as above.
double pressure_factor(const PatirCheng& law, double l);
double pressure_factor_slope(const PatirCheng& law, double l);
/// Phi_s and its derivative: the flow that the sliding of a rough surface against a smooth one drags along, over
/// sigma (u1 - u2)/2. Of two rough surfaces phi_s = (sigma1/sigma)^2 Phi_s(gamma1) - (sigma2/sigma)^2 Phi_s(gamma2).
double shear_factor(const PatirCheng& law, double l);
double shear_factor_slope(const PatirCheng& law, double l);

/// phi_c = dh_T/dh of Gaussian heights that are cut off where they would overlap; h_T is the mean gap between:
/// phi_c = (1 + erf(l/sqrt(2)))/2 and h_T/sigma = l phi_c + exp(-l^2/2)/sqrt(2 pi).
/// source: Wu and Zheng (1989), J. Tribol. 111, 872, whose polynomial fits this.
double contact_factor(double l);
double mean_gap(double l);

/// A factor between the points of a table: monotone cubics. Beyond the last gap the deviation from 1 falls with h^-2,
/// as it does for roughness that is small against the gap; below the first gap the factor keeps its value there.
struct TabulatedFactor {
  std::shared_ptr<const rheology::Curve> curve{};
  double first_gap = 0.0, last_gap = 0.0;  ///< [m]
};
TabulatedFactor tabulated_factor(std::span<const double> gaps, std::span<const double> factors);

/// The flow factors of a contact, functions of H. Exactly one of the two models holds.
struct FlowFactors {
  std::variant<PatirCheng, std::vector<TabulatedFactor>> model{};  ///< of a table: phi_x, phi_y
  double gap_scale = 1.0;                                          ///< h for H = 1 [m]: a^2/R
  double sigma = 1.0;                                              ///< [m], for Patir and Cheng
};
FlowFactors flow_factors(const GapTable& table, double gap_scale);

/// phi_x(H), phi_y(H) and their derivatives with respect to H. out: spans of the same length as H.
void phi_x(const FlowFactors& factors, std::span<const double> H, std::span<double> out);
void phi_y(const FlowFactors& factors, std::span<const double> H, std::span<double> out);
void phi_x_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out);
void phi_y_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out);
/// Phi_s(H) of Patir and Cheng, and its derivative; zero for a table, which has no such factor.
void phi_s(const FlowFactors& factors, std::span<const double> H, std::span<double> out);
void phi_s_slope(const FlowFactors& factors, std::span<const double> H, std::span<double> out);

}  // namespace ehl::asperities
