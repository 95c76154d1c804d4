#pragma once
// Pressure and film at chosen points.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::transient {

/// A point in Hertz radii.
struct Place {
  double X = 0.0, Y = 0.0;
};

/// Values at a probe.
struct Probed {
  double P = 0.0, H = 0.0;
};

/// P and H at every place: nodal values at nodes, else bicubic interpolation with P >= 0. in: the patch of the fields.
/// limits: the places lie in its domain.
std::vector<Probed> probed_at(const core::Patch& grid, const core::Field& P, const core::Field& H,
                              const std::vector<Place>& places);

}  // namespace ehl::transient
