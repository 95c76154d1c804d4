#pragma once
// A body that moves under the load and the film's pressure, instead of a load that is imposed.
#include <cmath>
#include <optional>

namespace ehl::transient {

/// The equation of motion of the body whose place is H00, in the normal direction:
///   mass H00'' + damping H00' = carried/W - load(T),   ' = d/dT, T = t u_m/a,
/// W the load that the groups are made with: the mass is in units of W R/u_m^2, the damping in W R/(a u_m).
struct Body {
  double mass = 0.0;            ///< > 0
  double damping = 0.0;         ///< >= 0
  std::optional<double> gap{};  ///< H00 at T = 0, without pressure; absent: the steady state's
  double velocity = 0.0;        ///< V = H00' at T = 0; negative: approaching
};

/// Frequency of small free vibrations upon the dry contact, 1/T: mass Omega^2 = 3/2, by carried/W = (-H00)^(3/2).
inline double natural_frequency(const Body& body) { return std::sqrt(1.5 / body.mass); }

}  // namespace ehl::transient
