#pragma once
// How the flow that pressure drives thins the oil itself, beside the sliding (shear.hpp).
//
// Across a film of one viscosity the stress is tau(zeta) = t + s g, s = zeta - 1/2, with components along the sliding
// and across it; the rate F(|tau|) tau/|tau| has the mean (sliding, 0), and its moment -int s rate is the mean velocity
// of the pressure's flow over h. That flow is given, not the gradient g: flow/g then falls more slowly than the
// flow grows, and a pass from flow to g and back settles.
// limits: one viscosity across the film; the flow is odd in g, so that each direction has its own secant flow/g.
#include "core/simd.hpp"
#include "rheology/shear.hpp"

namespace ehl::rheology {

/// Velocities are in u_m, stresses in tau_c.
struct FlowThinning {
  ShearLaw law;
  double k_m = 0.0;      ///< eta_0 u_m R/(a^2 tau_c) > 0: a film sheared by u_m, where H = 1 and eta_bar = 1
  double sliding = 0.0;  ///< |u1 - u2|/u_m
};

/// Over what sliding alone leaves (film_fluidity()).
struct FlowThinned {
  core::Lanes along, across;  ///< mobilities: secants flow/g
  core::Lanes stress;         ///< mean stress of sliding
};

/// in: H fluidity > 0; mean velocities of the flow, of either sign. Gauss's rule of eight points and Newton's method
/// for t and g: errors 1e-7 where g is below 6 tau_c, 3e-5 at 15. limits: a flow that shears by less than 1e-3 of tau_c
/// counts as that: its thinning is below 1e-7.
FlowThinned thinned_by_flow(const FlowThinning& thinning, core::Lanes H_fluidity, core::Lanes flow_x,
                            core::Lanes flow_y);

}  // namespace ehl::rheology
