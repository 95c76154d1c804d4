#pragma once
// Shear thinning by the pressure flow itself, in addition to that by sliding (shear.hpp).
//
// Across a film of one viscosity the stress is tau(zeta) = t + s g, s = zeta - 1/2, with components along and across
// the sliding direction. The shear rate F(|tau|) tau/|tau| has the mean (sliding, 0), and its moment -int s rate is the
// mean velocity of the pressure flow over h. That flow is given, not the gradient g: the secant flow/g then varies more
// slowly than the flow, so that a fixed-point iteration between flow and g converges.
// limits: one viscosity across the film; the flow is odd in g, so that each direction has its own secant flow/g.
#include "rheology/shear.hpp"

namespace ehl::rheology {

/// Velocities in u_m, stresses in tau_c.
struct FlowThinning {
  ShearLaw law;
  double k_m = 0.0;      ///< eta_0 u_m R/(a^2 tau_c) > 0: shear by u_m at H = 1 and eta_bar = 1
  double sliding = 0.0;  ///< |u1 - u2|/u_m
};

}  // namespace ehl::rheology
