#pragma once
// Whether the mesh resolves the surfaces of a scene.
#include "steady/error_bars.hpp"

namespace ehl::steady {

struct Scene;

/// Share of the variance of the surface heights that is lost on half as many cells, where both grids hold cell means; 0
/// for smooth surfaces. A wave with n cells per length loses 1 - cos^2(pi/n).
double relief_lost(const Scene& scene);

/// If that share is too large, the highest pressure belongs to the sharpest asperity that this mesh shows: removes the
/// error bar of P_max and marks it.
void leave_open_on_relief(const Scene& scene, ErrorBars& bars);

}  // namespace ehl::steady
