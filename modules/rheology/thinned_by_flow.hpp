#pragma once
// Solution of the equations of flow_thinning.hpp for one film per vector lane.
#include "core/simd.hpp"
#include "rheology/flow_thinning.hpp"

namespace ehl::rheology {

/// Lower bound of H, which keeps divisions by the film finite.
constexpr double least_film = 1e-6;

/// Factors over thinning by sliding alone (film_fluidity()).
struct FlowThinned {
  core::Lanes along, across;  ///< mobilities: secants flow/g
  core::Lanes stress;         ///< mean stress of sliding
};

/// in: H fluidity > 0; mean velocities of the flow, of either sign; near: the factors at a similar film and flow, from
/// which fewer Newton steps are needed. Gauss rule with eight points, Newton's method for t and g. error: grows with g,
/// [bench: flow_thinning_points]. limits: a flow that shears by less than no_stress (flow_thinning.cpp) counts as that
/// value.
FlowThinned thinned_by_flow(const FlowThinning& thinning, core::Lanes H_fluidity, core::Lanes flow_x,
                            core::Lanes flow_y, const FlowThinned* near = nullptr);

}  // namespace ehl::rheology
