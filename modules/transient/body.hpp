#pragma once
// A body that moves under the applied load and the film pressure; without it the film carries the load at all times.
#include <cmath>
#include <optional>

namespace ehl::transient {

/// Equation of motion of the body in the normal direction; H00 is its position:
///   mass H00'' + damping H00' = carried/W - load(T),   ' = d/dT, T = t u_m/a.
/// W is the load from which the dimensionless groups are made. Units: mass W R/u_m^2, damping W R/(a u_m).
struct Body {
  double mass = 0.0;            ///< > 0
  double damping = 0.0;         ///< >= 0
  std::optional<double> gap{};  ///< H00 at T = 0, without pressure; absent: H00 of the steady state
  double velocity = 0.0;        ///< V = H00' at T = 0; negative while the bodies approach
};

/// Angular frequency of small free vibrations of the dry contact, in 1/T: mass Omega^2 = 3/2, since
///   carried/W = (-H00)^(3/2).
inline double natural_frequency(const Body& body) { return std::sqrt(1.5 / body.mass); }

}  // namespace ehl::transient
