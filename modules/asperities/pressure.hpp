#pragma once
// The mean pressure of touching asperities as a function of the gap.
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "rheology/table.hpp"

namespace ehl::asperities {

/// p(h) > 0, which falls with the gap h. Between its points -ln p is a cubic with continuous slope; outside them it is
/// linear, so that p falls exponentially beyond the last gap and grows exponentially below the first.
struct PressureCurve {
  std::shared_ptr<const rheology::Curve> fall{};  ///< -ln(p/Pa) against h - first_gap [m]
  double first_gap = 0.0;                         ///< [m]
};

/// in: gaps [m], increasing, and pressures [Pa] > 0, falling, at least 3; slopes dp/dh [Pa/m] < 0 if they are known:
/// without them the cubics are monotone (rheology::monotone_curve). order: 4 with slopes, 2 to 3 without.
PressureCurve pressure_curve(std::span<const double> gaps, std::span<const double> pressures,
                             std::span<const double> slopes = {});

/// The law P_a(H) in the scales of a contact.
///
///   P_a = p_c(h)/p_h,  h = gap_scale H,  p_c = p/(1 + (p/hardness)^8)^(1/8)
///
/// The asperities yield at the hardness of the softer body, so the mean pressure stays below it. The cap p_c is
/// smooth and grows with p: it is below p by 0.05 % at half of the hardness and by 8 % where p equals the hardness.
struct AsperityPressure {
  PressureCurve curve{};
  double gap_scale = 1.0;                                     ///< h for H = 1 [m]: a^2/R
  double p_h = 1.0;                                           ///< [Pa]
  double hardness = std::numeric_limits<double>::infinity();  ///< [Pa]
};

/// P_a and dP_a/dH < 0. in: H; out: spans of the same length. cost: an exponential and a power per value.
void pressure(const AsperityPressure& law, std::span<const double> H, std::span<double> P);
void pressure_slope(const AsperityPressure& law, std::span<const double> H, std::span<double> dP);

}  // namespace ehl::asperities
