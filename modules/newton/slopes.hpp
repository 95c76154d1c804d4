#pragma once
// Derivatives of the residual by P and H of single nodes, row by row: the Jacobian without the deformation.
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "newton/equations.hpp"

namespace ehl::newton {

/// Nodes on which the equation of a node may depend, up to two cells away along X or Y: by their film; by their
/// pressure only the first six.
inline constexpr std::array<std::pair<int, int>, 9> stencil{
    {{0, 0}, {-1, 0}, {1, 0}, {-2, 0}, {0, -1}, {0, 1}, {2, 0}, {0, -2}, {0, 2}}};

/// Derivatives s dr/dP or s dr/dH of each equation by the nodes of its stencil, with the other variable held fixed; in
/// storage order.
using Slopes = std::vector<std::array<double, stencil.size()>>;
enum class By { pressure, film };

/// Computes the derivatives by probing the linearized equations, many nodes of one colour at a time. in: linearized
/// equations. cost: 7 (pressure) or 10 (film) evaluations of the equations without the deformation; for a line
/// contact 4 or 5.
Slopes slopes(Equations& equations, By by);

}  // namespace ehl::newton
