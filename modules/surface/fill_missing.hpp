#pragma once
// Points of a map that an instrument could not measure.
#include <string>

#include "surface/height_map.hpp"

namespace ehl::surface {

/// Fills missing points (NaN) so that each is the mean of its neighbours, by successive over-relaxation; this preserves
/// a plane. out: the number of filled points, and an error message if too many points are missing, else empty.
std::string fill_missing(Heights& z, int& filled);

}  // namespace ehl::surface
