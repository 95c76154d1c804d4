#pragma once
#include <cstddef>

#include "core/grid.hpp"

namespace ehl::transient {

/// Calls action(i, j, k) for all nodes; k is the node's index in y.
template <class Action>
void for_nodes(const core::Patch& grid, Action action) {
  std::size_t k = 0;
  for (int i = 0; i <= grid.nx; ++i)
    for (int j = 0; j <= grid.ny; ++j) action(i, j, k++);
}

}  // namespace ehl::transient
