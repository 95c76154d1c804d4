#pragma once
// A height map on a mesh, and what the mesh does not resolve.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "surface/height_map.hpp"

namespace ehl::surface {

/// Adds to each node the mean, over the cell hx by hy around it, of the surface through the map's points; the map has
/// moved by `distance` along X. Between points the surface is Keys' cubic convolution (a = -1/2), which interpolates
/// and reproduces polynomials of degree two; the mean over a cell is exact. On a coarse mesh this averages: a wave of
/// length w keeps sin(pi h/w)/(pi h/w) of its amplitude. On a fine mesh it interpolates. The result has two continuous
/// derivatives with respect to the distance, so a second-order time integration sees no kink when a point passes a
/// node.
/// cost: per node (hx/dx + 4) additions, and for every line of the mesh (hy/dy + 4) per point of the map along x.
/// source: Keys 1981 for the cubic convolution.
void add_average(const HeightMap& map, const core::Patch& grid, double distance, core::Field& S);

/// What a mesh resolves of a map.
struct Resolution {
  double variance_lost = 0.0;    ///< share of the mean square of the map that averaging over the cells removes
  double shortest_wave_X = 0.0;  ///< two cells, or two points of the map if that is longer
  double shortest_wave_Y = 0.0;
};
/// limits: resolved waves with few cells are also weakened, and that loss is included.
Resolution resolution(const HeightMap& map, const core::Patch& grid);

}  // namespace ehl::surface
