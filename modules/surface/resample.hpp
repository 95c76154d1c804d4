#pragma once
// A height map on a mesh, and what the mesh loses of it.
#include "core/field.hpp"
#include "core/grid.hpp"
#include "surface/height_map.hpp"

namespace ehl::surface {

/// Adds to each node the mean over the cell around it, hx by hy, of the surface through the map's points, the map
/// having moved by `distance` along X. Between the points the surface is Keys' cubic convolution (a = -1/2), which
/// passes through them and reproduces polynomials of degree two; its mean over a cell is exact. Where the mesh is
/// coarser than the map that is an average over what the cell holds, a wave of length w being left with sin(pi h/w)/(pi
/// h/w) of its amplitude; where it is finer, an interpolation. As a function of the distance it has two continuous
/// derivatives: a time integration of second order sees no corner when a point of the map passes a node. cost: per node
/// (hx/dx + 4) additions, and per point of the map along x (hy/dy + 4) for every line of the mesh. source: Keys 1981
/// for the cubic convolution.
void add_average(const HeightMap& map, const core::Patch& grid, double distance, core::Field& S);

/// What a mesh holds of a map.
struct Resolution {
  double variance_lost = 0.0;    ///< share of the map's mean square that averaging over the mesh's cells takes away
  double shortest_wave_X = 0.0;  ///< two cells, or two points of the map where that is longer
  double shortest_wave_Y = 0.0;
};
/// errors: of the kept waves, those with few cells are weakened too, and count as lost by as much.
Resolution resolution(const HeightMap& map, const core::Patch& grid);

}  // namespace ehl::surface
