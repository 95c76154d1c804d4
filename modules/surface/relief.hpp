#pragma once
// Relief of one surface: a formula or a measured map.
#include <variant>

#include "surface/feature.hpp"
#include "surface/height_map.hpp"

namespace ehl::surface {

using Relief = std::variant<Feature, HeightMap>;

/// Adds S at the nodes, the surface having moved by `distance` along X: for a feature the nodal value, for a map the
/// mean over the cell.
void add_gap(const Relief& relief, const core::Patch& grid, double distance, core::Field& S);

/// Adds the mean of S over each node's cell, with the surface at its position at T = 0.
void add_cell_average(const Relief& relief, const core::Patch& grid, core::Field& S);

/// True if S(X, Y) = S(X, -Y) at all times.
bool symmetric(const Relief& relief);

/// Longest distance that the surface may move in one time step and still be resolved.
double resolving_distance(const Relief& relief);

}  // namespace ehl::surface
