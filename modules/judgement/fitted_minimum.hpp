#pragma once
// The minimum of the film between the nodes.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::judgement {

struct FittedMinimum {
  double value = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// The minimum of the film between the nodes around the smallest one, (i, j): that of the polynomial of degree four
/// along x and y through the 25 nodes around it, found by Newton's method. It starts from the minimum of the paraboloid
///   H(x, y) = H_ij + g x + k y + (a x^2 + 2 b x y + c y^2)/2,
/// with coefficients by central differences over the eight neighbours. The smallest node misses the minimum by up to an
/// eighth of the second differences, and the paraboloid by third differences. Both errors depend on where the nodes
/// happen to lie, and so hide the order of convergence of Hm.
/// order: h^5 for a smooth film.
/// limits: the result is the paraboloid's minimum within two nodes of a boundary, or if the quartic has no minimum
/// nearby. It is the node itself on the boundary, if the paraboloid has no minimum, or if that is more than 2.5 cells
/// away along x or y.
FittedMinimum fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

/// The weight of a node's film in a number derived from the film.
struct NodeWeight {
  int i = 0, j = 0;
  double weight = 0.0;
};

/// Derivatives of the fitted minimum with respect to the film at the nodes.
std::vector<NodeWeight> weights_of_fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

}  // namespace ehl::judgement
