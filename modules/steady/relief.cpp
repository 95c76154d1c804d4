#include "steady/relief.hpp"

#include <algorithm>

#include "core/constants.hpp"
#include "core/field.hpp"
#include "steady/scene.hpp"

namespace ehl::steady {
namespace {

double variance(const Scene& scene, const core::Grid& grid) {
  const core::Patch patch(grid);
  core::Field S(patch);
  scene.surface(patch, S);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i <= patch.nx; ++i)
    for (int j = 0; j <= patch.ny; ++j) {
      sum += S(i, j);
      squares += S(i, j) * S(i, j);
    }
  const double nodes = static_cast<double>(patch.nx + 1) * (patch.ny + 1);
  return squares / nodes - (sum / nodes) * (sum / nodes);
}

}  // namespace

double relief_lost(const Scene& scene) {
  if (!scene.surface || scene.grid.nx % 2 != 0 || scene.grid.ny % 2 != 0) return 0.0;
  const double fine = variance(scene, scene.grid);
  return fine > 0.0 ? std::max(0.0, 1.0 - variance(scene, core::coarsened(scene.grid)) / fine) : 0.0;
}

void leave_open_on_relief(const Scene& scene, ErrorBars& bars) {
  const double lost = relief_lost(scene);
  if (!(lost > scene.tuning.relief_lost)) return;
  bars.relief_unresolved = lost;
  bars.P_max = core::unknown;
  bars.P_max_converging = false;
}

}  // namespace ehl::steady
