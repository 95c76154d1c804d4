#pragma once
// What is computed of a solved roller: its distributions with and without oil, and on half as many cells.
#include <optional>

#include "core/constants.hpp"
#include "effects/roller/distribution.hpp"
#include "effects/subsurface/stress.hpp"
#include "steady/scene.hpp"
#include "steady/solve.hpp"

namespace ehl::roller {

/// Largest von Mises stress at the nodes of the middle half of the length, and near the ends; NaN: not computed.
struct Stresses {
  double middle = core::unknown, end = middle;
};

/// The load distribution of a roller: with oil, with oil on a grid of half as many cells, and without oil.
struct Analysis {
  Distribution found{};
  bool solved = true;  ///< the contact was solved; otherwise the coarser grid is not tried
  std::optional<Distribution> coarser{};
  Distribution dry{};
  /// False if a pressure spike may still grow or lie between the nodes. The coarser grid then gives no error bars for
  /// the highest pressures and the stresses.
  bool pressures_settle = true;
  Stresses mises{}, mises_coarser{};  ///< if the stresses below the contact are computed
  double seconds = 0.0;
};

/// in: the scene and its solution, converged or not; traced: the profile was measured, so that its roughness may
/// prevent a solution on the coarser grid; stresses: below the contact, or nullptr. cost: a dry contact, and a film on
/// half as many cells if the contact was solved. errors: core::Interrupted; those of dry::solve().
Analysis analyse(steady::Scene scene, const steady::Solution& solution, bool traced,
                 const subsurface::StressField* stresses, const steady::ProgressCallback& progress);

}  // namespace ehl::roller
