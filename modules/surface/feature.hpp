#pragma once
// What a surface carries: its deviation from smooth, by a formula.
#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::surface {

/// One deviation of one surface. All lengths in Hertz radii, heights in a^2/R; (xi, zeta) are the coordinates of the
/// surface with the feature's middle as origin. S is what the gap gains.
struct Feature {
  enum class Shape {
    dimple,    ///< S = height exp(-(r/width)^2)
    bump,      ///< S = -height exp(-(r/width)^2)
    ridge,     ///< S = -height exp(-(d/width)^2), d the distance from a line
    groove,    ///< S = height exp(-(d/width)^2)
    waviness,  ///< S = height cos(2 pi d/width); with a front, ahead of the middle 10^(-10 (dX/width)^2) of it
    cavity     ///< S = height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2), Mourier et al. 2006
  };
  Shape shape = Shape::dimple;
  double height = 0.0;
  double width = 0.0;
  double angle = 0.0;  ///< between the line (ridge, groove, waves) and the Y axis, in radians
  double X = 0.0;      ///< of the middle at T = 0
  double Y = 0.0;
  bool front = true;  ///< of waves: they end ahead of the middle; false: they stand everywhere
};

/// S at a distance (dX, dY) from the feature's middle.
double gap_of(const Feature& feature, double dX, double dY);

/// Adds S to the field, the feature having moved by `distance` along X.
void add_gap(const Feature& feature, const core::Patch& grid, double distance, core::Field& S);

/// Adds to each node the mean of S over the cell around it, hx by hy: what a grid too coarse for the feature can hold
/// of it. order: of a feature that the grid resolves, S + h^2/24 (S_XX + S_YY); the quadrature's own error is below
/// 1e-3 of the height. cost: four evaluations per node, more where a cell is wider than a quarter of the width.
void add_cell_average(const Feature& feature, const core::Patch& grid, core::Field& S);

/// True where S(X, Y) = S(X, -Y) at all times.
bool symmetric(const Feature& feature);

/// Longest distance that the feature may move in one step of time and still be seen: a quarter of its length along X.
double resolving_distance(const Feature& feature);

}  // namespace ehl::surface
