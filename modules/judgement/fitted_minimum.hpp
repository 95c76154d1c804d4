#pragma once
// The smallest film between the nodes.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::judgement {

struct FittedMinimum {
  double value = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

/// The minimum between the nodes around the smallest one, (i, j): of the polynomial of degree four along x and y
/// through the 25 nodes about it, found by Newton's method from the minimum of the paraboloid
///   H(x, y) = H_ij + g x + k y + (a x^2 + 2 b x y + c y^2)/2,
/// the coefficients by central differences over the eight neighbours. The smallest node misses the minimum by up to
/// an eighth of the second differences, the paraboloid by third ones: by shares that depend on where the mesh happens
/// to lie, and so hide the order of convergence of Hm. measured: (50, 10) on 64, 128, 256 cells a unit long: paraboloid
/// 1.5e-3, 3e-4, 6e-7, the quartic 1.4e-4, 5e-6, 2e-8. order: h^5, for a smooth film.
/// limits: the paraboloid's minimum within two nodes of a boundary, or where the quartic has none beside it; the node
/// itself on the boundary, where the paraboloid has no minimum, or where the minimum is more than 2.5 cells away along
/// x or y.
FittedMinimum fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

/// A node's share of a number that is made of the film.
struct NodeWeight {
  int i = 0, j = 0;
  double weight = 0.0;
};

/// By how much a change of the film at the nodes changes the fitted minimum, to first order.
std::vector<NodeWeight> weights_of_fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

}  // namespace ehl::judgement
