#pragma once
// Gaussian filters for measured surfaces: the part longer than a cut-off wavelength.
#include <span>
#include <vector>

#include "surface/height_map.hpp"

namespace ehl::surface {

/// Long waves of a profile by Gaussian regression of second order: at each point a parabola by weighted least squares,
/// with weights exp(-pi (x/(0.7309 cut_off))^2) times the length that a point represents. A wave of the cut-off length
/// keeps half of its amplitude; parabolas, the form of a roller, pass unchanged up to the ends.
/// in: x increasing, at least three points; cut_off > 0 in units of x. cost: points times points within 1.5 cut-offs.
/// source: ISO 16610-31 without its robust weights.
std::vector<double> long_waves(std::span<const double> x, std::span<const double> z, double cut_off);

/// Long waves of a map by the areal Gaussian filter, weights exp(-pi (r/(0.4697 cut_off))^2), divided by their sum near
/// the edges. A wave of the cut-off length keeps half of its amplitude in any direction.
/// in: distances between points, and cut-off, in the same unit. source: ISO 16610-61.
Heights long_waves(const Heights& heights, double dx, double dy, double cut_off);

}  // namespace ehl::surface
