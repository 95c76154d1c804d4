#include "newton/content_rows.hpp"

#include <algorithm>

#include "reynolds/content.hpp"

namespace ehl::newton {

void ContentRows::make(const multigrid::Level& level, const reynolds::Transport& transport) {
  const core::Patch& grid = level.grid;
  stride_ = static_cast<std::size_t>(grid.nodes_y());
  rows_.resize(static_cast<std::size_t>(grid.nodes_x()) * stride_);
  const auto full = [&](int i, int j) { return level.rho_bar(i, j) * level.H(i, j); };
  const auto theta = [&](int i, int j) {
    return reynolds::third_order(transport.wedge) && i > 0 ? level.third_order(i, j) : 0.0;
  };
  for (int j = 1; j <= grid.last_line(); ++j) {
    reynolds::March<double> march(transport, grid.hx(), level.content->Q(0, j), full(0, j));
    for (int i = 1; i < grid.nx; ++i) {
      const double own = full(i, j);
      const double r = march.residual(own, full(i + 1, j), {theta(i - 1, j), theta(i, j)}, 0.0);
      rows_[static_cast<std::size_t>(i) * stride_ + static_cast<std::size_t>(j)] = {
          march.weights(), march.weights_behind(), march.third_order_share(), level.content->Q(i, j) < own,
          march.behind_dry()};
      march.go_on_with(own, level.content->Q(i, j), r, level.content->chatters(i, j) > 0.0);
    }
  }
}

}  // namespace ehl::newton
