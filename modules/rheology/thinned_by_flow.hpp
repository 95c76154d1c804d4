#pragma once
// The solution of flow_thinning.hpp, of as many films side by side as there are lanes.
#include "core/simd.hpp"
#include "rheology/flow_thinning.hpp"

namespace ehl::rheology {

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
