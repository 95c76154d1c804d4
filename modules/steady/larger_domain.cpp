#include "steady/larger_domain.hpp"

namespace ehl::steady {

Sides sides_of(const Scene& scene) { return contact::line(scene.contact.shape) ? Sides::stay : Sides::move; }

core::Grid doubled(const core::Grid& grid, Sides sides) {
  core::Grid larger = grid;
  larger.nx *= 2;
  larger.X_a -= grid.X_b - grid.X_a;
  if (sides == Sides::move) larger.ny *= 2, larger.Y_a *= 2.0, larger.Y_b *= 2.0;
  return larger;
}

core::Grid with_cells(const core::Grid& grid, int nx) {
  core::Grid finer = grid;
  finer.ny *= grid.finer_lines(nx / grid.nx);
  finer.nx = nx;
  return finer;
}

core::Grid on_larger_domain(const core::Grid& grid, double factor, Sides sides) {
  const double wanted = factor * (grid.X_b - grid.X_a) * (1.0 - 1e-12);
  int parts = 32;  // m of these parts lie upstream of 0
  int m = 16;
  const auto length = [&] { return grid.X_b * parts / (parts - m); };
  for (; length() < wanted; ++m)
    if (m + 1 == parts) parts *= 2;
  core::Grid larger = grid;
  larger.X_a = -grid.X_b * m / (parts - m);
  const double ratio = length() / (grid.X_b - grid.X_a);
  if (sides == Sides::move) {
    larger.Y_a *= ratio;
    larger.Y_b *= ratio;
  }
  while (larger.hx() > grid.hx() * (1.0 + 1e-12)) larger = with_cells(larger, 2 * larger.nx);
  return larger;
}

}  // namespace ehl::steady
