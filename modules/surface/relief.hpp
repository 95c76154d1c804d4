#pragma once
// What one surface carries, by a formula or as a measured map.
#include <variant>

#include "surface/feature.hpp"
#include "surface/height_map.hpp"

namespace ehl::surface {

using Relief = std::variant<Feature, HeightMap>;

/// Adds S at the nodes, the surface having moved by `distance` along X: a feature's value there, a map's mean over the
/// cell.
void add_gap(const Relief& relief, const core::Patch& grid, double distance, core::Field& S);

/// Adds the mean of S over each node's cell, the surface standing where it is at T = 0.
void add_cell_average(const Relief& relief, const core::Patch& grid, core::Field& S);

/// True where S(X, Y) = S(X, -Y) at all times.
bool symmetric(const Relief& relief);

/// Longest distance that the surface may move in one step of time and still be seen.
double resolving_distance(const Relief& relief);

}  // namespace ehl::surface
