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

/// Minimum of the paraboloid through the nodes around the smallest one, (i, j):
///   H(x, y) = H_ij + g x + k y + (a x^2 + 2 b x y + c y^2)/2,
/// the coefficients by central differences over the eight neighbours. The smallest node misses the minimum by up to
/// an eighth of the second differences, by a share that depends on where the mesh happens to lie: that hides the
/// order of convergence of Hm, and the paraboloid takes the most of it away. order: h^3, for a smooth film.
/// limits: the node itself where it lies on the boundary, where the paraboloid has no minimum, or where the minimum is
/// more than 2.5 cells away along x or y.
FittedMinimum fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

/// A node's share of a number that is made of the film.
struct NodeWeight {
  int i = 0, j = 0;
  double weight = 0.0;
};

/// By how much a change of the film at the nodes changes the fitted minimum, to first order.
std::vector<NodeWeight> weights_of_fitted_minimum(const core::Patch& grid, const core::Field& film, int i, int j);

}  // namespace ehl::judgement
