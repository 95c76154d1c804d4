#pragma once
// Finer grids of a domain, and larger domains for what it cuts off.
#include "steady/scene.hpp"

namespace ehl::steady {

/// The same domain with nx cells along x, and as many more along y. in: nx a multiple of the cells there are.
core::Grid with_cells(const core::Grid& grid, int nx);

/// What becomes of the sides of a domain that grows: a line contact has none, a roller ends there.
enum class Sides { move, stay };
Sides sides_of(const Scene& scene);

/// Twice as long (upstream) and, where its sides move, twice as wide, with the same nodes where both are: the error of
/// the mesh is the same.
core::Grid doubled(const core::Grid& grid, Sides sides);

/// The grid of the same cells or finer, and cells of at most the same size, on a domain that is longer (upstream) and,
/// where its sides move, wider by `factor` at least; (0,0) stays a node. in: a grid whose number of cells can be halved
/// down to 64 or less.
core::Grid on_larger_domain(const core::Grid& grid, double factor, Sides sides = Sides::move);

}  // namespace ehl::steady
