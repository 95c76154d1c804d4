#include "adjoint/truncation.hpp"

#include <algorithm>

#include "multigrid/start.hpp"
#include "reynolds/flux.hpp"

namespace ehl::adjoint {
namespace {

double wedge_at(const multigrid::Hierarchy& hierarchy, const multigrid::Level& level, int i, int j) {
  const reynolds::Transport transport = multigrid::transport_on(hierarchy, level);
  const core::Field& theta = level.third_order;
  const reynolds::ThirdOrder<double> around =
      theta.nodes_x() > 0 ? reynolds::ThirdOrder<double>{theta(i - 1, j), theta(i, j)} : reynolds::ThirdOrder<double>{};
  const auto w = reynolds::third_order_weights(reynolds::transport_weights(transport, i, level.grid.hx()), transport,
                                               level.grid.hx(), around);
  const auto q = [&](int k) { return level.rho_bar(k, j) * level.H(k, j); };
  return reynolds::transported(w, q(i), q(i - 1), q(std::max(i - 2, 0)), q(i + 1));
}

}  // namespace

Truncation truncation(multigrid::Hierarchy& hierarchy, std::size_t coarse, std::size_t fine) {
  multigrid::Level& level = hierarchy.levels[coarse];
  multigrid::Level& finer = hierarchy.levels[fine];
  const core::Patch& grid = level.grid;
  const int step = 1 << (fine - coarse);
  const auto injected = [&](const core::Field& field) {
    core::Field at(grid);
    for (int i = 0; i <= grid.nx; ++i)
      for (int j = 0; j <= grid.ny; ++j) at(i, j) = field(i * step, grid.finer_line(j, step));
    return at;
  };
  multigrid::update_residual(hierarchy, finer);
  multigrid::start_from_state(hierarchy, coarse, {injected(finer.P), hierarchy.H00});
  Truncation parts{core::Field(grid), core::Field(grid), core::Field(grid),
                   multigrid::carried_load(level) - level.load};
  multigrid::update_film(hierarchy, level);
  multigrid::update_residual(hierarchy, level);
  const core::Field own_r = level.r;
  const core::Field own_film = level.H;
  level.H = injected(finer.H);
  multigrid::update_coefficients(hierarchy, level);
  multigrid::update_residual(hierarchy, level);
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const int finer_j = grid.finer_line(j, step);
      if (level.P(i, j) <= 0.0) {
        parts.poiseuille(i, j) = own_r(i, j);
        continue;
      }
      parts.film(i, j) = own_r(i, j) - level.r(i, j);
      parts.wedge(i, j) = wedge_at(hierarchy, level, i, j) - wedge_at(hierarchy, finer, i * step, finer_j);
      parts.poiseuille(i, j) = level.r(i, j) - finer.r(i * step, finer_j) - parts.wedge(i, j);
    }
  level.H = own_film;
  multigrid::update_coefficients(hierarchy, level);
  level.r = own_r;
  return parts;
}

}  // namespace ehl::adjoint
