#pragma once
// Whether a mesh resolves the surfaces of a scene.
#include "steady/error_bars.hpp"

namespace ehl::steady {

struct Scene;

/// Share of the variance of the surfaces' heights that half as many cells lose, both grids holding means over cells; 0
/// for smooth surfaces. A wave that has n cells per length loses 1 - cos^2(pi/n).
double relief_lost(const Scene& scene);

/// Where it is more than a mesh may lose, the highest pressure is that of the sharpest asperity that the mesh holds:
/// takes its error from P_max and marks it.
void leave_open_on_relief(const Scene& scene, ErrorBars& bars);

}  // namespace ehl::steady
