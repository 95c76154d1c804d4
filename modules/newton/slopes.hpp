#pragma once
// What single nodes change of the residual, row by row: the Jacobian without the deformation.
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "newton/equations.hpp"

namespace ehl::newton {

/// Nodes that may take part in the equation of a node, up to two cells away along X or Y: by their film; by their
/// pressure the first six.
inline constexpr std::array<std::pair<int, int>, 9> stencil{
    {{0, 0}, {-1, 0}, {1, 0}, {-2, 0}, {0, -1}, {0, 1}, {2, 0}, {0, -2}, {0, 2}}};

/// s dr of each equation by one of P and H at the nodes of its stencil, the other held; in order of storage.
using Slopes = std::vector<std::array<double, stencil.size()>>;
enum class By { pressure, film };

/// in: linearized equations. cost: 7 or 10 evaluations of the equations without the deformation, of a line contact 4 or
/// 5.
Slopes slopes(Equations& equations, By by);

}  // namespace ehl::newton
