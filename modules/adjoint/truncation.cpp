#include "adjoint/truncation.hpp"

#include "multigrid/start.hpp"
#include "reynolds/row.hpp"

namespace ehl::adjoint {
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
  const reynolds::NodeRows rows = multigrid::rows(hierarchy, level), finer_rows = multigrid::rows(hierarchy, finer);
  const auto wedge = [](const reynolds::NodeRows& of, int i, int j) {
    return reynolds::transported(of.weights(i, j), of.Q(i, j));
  };
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) {
      const int finer_j = grid.finer_line(j, step);
      if (level.P(i, j) <= 0.0) {
        parts.poiseuille(i, j) = own_r(i, j);
        continue;
      }
      parts.film(i, j) = own_r(i, j) - level.r(i, j);
      parts.wedge(i, j) = wedge(rows, i, j) - wedge(finer_rows, i * step, finer_j);
      parts.poiseuille(i, j) = level.r(i, j) - finer.r(i * step, finer_j) - parts.wedge(i, j);
    }
  level.H = own_film;
  multigrid::update_coefficients(hierarchy, level);
  level.r = own_r;
  return parts;
}

}  // namespace ehl::adjoint
