#pragma once
// The contact at chosen points.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::transient {

/// A point in Hertz radii.
struct Place {
  double X = 0.0, Y = 0.0;
};

/// What a probe shows.
struct Probed {
  double P = 0.0, H = 0.0;
};

/// P and H at every place: of a node where there is one, else by bicubic interpolation, P no less than 0.
/// in: the patch of the fields. limits: inside its domain.
std::vector<Probed> probed_at(const core::Patch& grid, const core::Field& P, const core::Field& H,
                              const std::vector<Place>& places);

}  // namespace ehl::transient
