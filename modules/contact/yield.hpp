#pragma once
// Limits of elastic contact: yield.
#include <optional>

#include "core/warning.hpp"

namespace ehl::contact {

/// Approximate yield stress of hardened bearing steel (such as 100Cr6 of 60 HRC) [Pa].
inline constexpr double bearing_steel_yield = 2e9;
/// Hertz pressure over yield stress at which a body of a circular contact first yields, below its surface.
/// source: Johnson, Contact Mechanics (1985), section 6.1: p_h = 1.60 Y (von Mises and Tresca, nu = 0.3). Elliptic
/// contacts up to the line contact yield at a pressure up to a tenth higher.
inline constexpr double first_yield = 1.6;
/// Hertz pressure of a ball on a raceway for a permanent deformation of both by 1e-4 of the ball's diameter [Pa].
/// source: ISO 76 (2006), basic static load rating of ball bearings.
inline constexpr double iso76_ball_pressure = 4.2e9;

/// A warning if hardened bearing steel yields under p_h [Pa] or is loaded above ISO 76; nullopt below, and if p_h is
/// NaN.
/// limits: softer materials yield earlier and are not considered.
std::optional<core::Warning> beyond_yield(double p_h);

}  // namespace ehl::contact
