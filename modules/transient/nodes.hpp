#pragma once
#include <cstddef>
#include <utility>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::transient {

/// Calls action(i, j, k) for all nodes; k is the index in y of the node (i, j), or, if `reversed`, of its mirror image
/// in X.
template <class Action>
void for_nodes(const core::Patch& grid, bool reversed, Action action) {
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j)
      action(i, j, static_cast<std::size_t>((reversed ? grid.nx - i : i) * grid.nodes_y() + j));
}
template <class Action>
void for_nodes(const core::Patch& grid, Action action) {
  for_nodes(grid, false, std::move(action));
}

/// Replaces a field by its mirror image in X; its ghost nodes stay as they are.
inline void mirror_in_X(const core::Patch& grid, core::Field& field) {
  for (int i = 0; 2 * i < grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) std::swap(field(i, j), field(grid.nx - i, j));
}

}  // namespace ehl::transient
