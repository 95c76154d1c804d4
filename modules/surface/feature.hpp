#pragma once
// Surface features: deviations from a smooth surface, given by formulas.
#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::surface {

/// One feature of one surface. Lengths in Hertz radii, heights in a^2/R; xi, zeta are surface coordinates with origin
/// at the centre of the feature. S is added to the gap.
struct Feature {
  enum class Shape {
    dimple,    ///< S = height exp(-(r/width)^2)
    bump,      ///< S = -height exp(-(r/width)^2)
    ridge,     ///< S = -height exp(-(d/width)^2), d the distance from the centre line
    groove,    ///< S = height exp(-(d/width)^2)
    waviness,  ///< S = height cos(2 pi d/width); with a front, times 10^(-10 (dX/width)^2) ahead of the centre
    cavity     ///< S = height cos(pi r/(2.4 width)) exp(-2 (r/(1.2 width))^2), Mourier et al. 2006
  };
  Shape shape = Shape::dimple;
  double height = 0.0;
  double width = 0.0;
  double angle = 0.0;  ///< of the line (ridge, groove, wave crests) to the Y axis, in radians
  double X = 0.0;      ///< of the centre at T = 0
  double Y = 0.0;
  bool front = true;  ///< waves end ahead of the centre; false: they cover the whole surface
};

/// S at a distance (dX, dY) from the centre of the feature.
double gap_of(const Feature& feature, double dX, double dY);

/// Adds S to the field; the feature has moved by `distance` along X.
void add_gap(const Feature& feature, const core::Patch& grid, double distance, core::Field& S);

/// Adds to each node the mean of S over the cell hx by hy around it, which is what a coarse grid can represent.
/// order: for a resolved feature S + h^2/24 (S_XX + S_YY); the error of the quadrature is below 1e-3 of the height.
/// cost: four evaluations per node, more if a cell is wider than a quarter of the width.
void add_cell_average(const Feature& feature, const core::Patch& grid, core::Field& S);

/// True if S(X, Y) = S(X, -Y) at all times.
bool symmetric(const Feature& feature);

/// Longest distance that the feature may move in one time step and still be resolved: a quarter of its length along X.
double resolving_distance(const Feature& feature);

}  // namespace ehl::surface
