#pragma once
// Where an elastic contact ends to be one.
#include <optional>
#include <string>

namespace ehl::contact {

/// Yield stress of hardened bearing steel (such as 100Cr6 of 60 HRC) [Pa], about.
inline constexpr double bearing_steel_yield = 2e9;
/// Hertz pressure of a circular contact at which a body first yields, below its surface, over the yield stress.
/// source: Johnson, Contact Mechanics (1985), section 6.1: p_h = 1.60 Y (von Mises and Tresca, nu = 0.3). An ellipse
/// yields at up to a tenth more, as far as a line contact.
inline constexpr double first_yield = 1.6;
/// Hertz pressure of a ball on a raceway at which the permanent deformation of both is 1e-4 of the ball's diameter
/// [Pa]. source: ISO 76 (2006), the basic static load rating of ball bearings.
inline constexpr double iso76_ball_pressure = 4.2e9;

/// A sentence with the numbers where hardened bearing steel yields under p_h [Pa], or is loaded beyond what ISO 76
/// permits; none below, and none where p_h is NaN. limits: softer bodies yield earlier, and nothing here knows them.
std::optional<std::string> beyond_yield(double p_h);

}  // namespace ehl::contact
