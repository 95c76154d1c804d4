#pragma once
// Finer grids on the same domain, and grids on larger domains.
#include "steady/scene.hpp"

namespace ehl::steady {

/// The given domain with nx cells along x and proportionally more along y. in: nx, a multiple of the present number.
core::Grid with_cells(const core::Grid& grid, int nx);

/// Whether the sides of a growing domain move: a line contact has none, and a roller ends there.
enum class Sides { move, stay };
Sides sides_of(const Scene& scene);

/// A domain twice as long (extended upstream) and, if its sides move, twice as wide. The common nodes coincide, so that
/// the error of the mesh is the same.
core::Grid doubled(const core::Grid& grid, Sides sides);

/// A domain that is longer (extended upstream) by at least `factor` and, if its sides move, wider by the same ratio.
/// The cells are at most as large as before; (0,0) stays a node. in: a grid whose number of cells can be halved down to
/// 64 or less.
core::Grid on_larger_domain(const core::Grid& grid, double factor, Sides sides = Sides::move);

}  // namespace ehl::steady
