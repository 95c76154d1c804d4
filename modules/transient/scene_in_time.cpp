#include "transient/scene_in_time.hpp"

#include <algorithm>
#include <limits>

#include "steady/resolution.hpp"

namespace ehl::transient {
namespace {

/// Where a line's logarithm is zero, in contact sizes: inside of the pressure a held film answers H00 wrongly. Of 55
/// contacts (M = 1 to 2000, L = 0 to 15) under a load that swings, 4 carries more through than 8.
constexpr double unit_of_line = 4.0;

}  // namespace

steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions) {
  steady::Scene scene = steady;
  scene.use_symmetry = steady.use_symmetry && symmetric(conditions);
  scene.multigrid.cycle = steady.multigrid.cycle.value_or(fmg::Cycle::V);  // from a predicted state V(2,1) is enough
  scene.multigrid.post = steady.multigrid.post.value_or(1);
  if (conditions.conserves_mass && !scene.supply)
    scene.supply = [](double) { return std::numeric_limits<double>::infinity(); };
  if (scene.grid.line)
    scene.deformation.line_unit = unit_of_line * std::max(1.0, steady::contact_size(scene.M, scene.L, scene.shape));
  return scene;
}

}  // namespace ehl::transient
