#include "transient/scene_in_time.hpp"

#include <algorithm>
#include <limits>

#include "steady/resolution.hpp"

namespace ehl::transient {
namespace {

/// Where a line's logarithm is zero, in contact sizes: inside of the pressure a held film answers H00 wrongly. Of 55
/// contacts (M = 1 to 2000, L = 0 to 15) under a load that swings, 4 carries more through than 8.
constexpr double unit_of_line = 4.0;

/// What single points around a point squeeze out of its film, H per P: a zone is as wide on any cells, so that with the
/// 2 K_0 of point contacts cycles diverge on fine ones (L = 0, M >= 200, c > 1e5). Beside the cavitated region there is
/// no zone: the 0.2 of point contacts, 20 times a line's K_0 at 1025 nodes, left 0.93 of an error there.
constexpr double far_squeeze_of_line = 0.2;

}  // namespace

steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions) {
  steady::Scene scene = steady;
  scene.use_symmetry = steady.use_symmetry && symmetric(conditions);
  scene.multigrid.cycle = steady.multigrid.cycle.value_or(fmg::Cycle::V);  // from a predicted state V(2,1) is enough
  scene.multigrid.pre = steady.multigrid.pre.value_or(2);
  scene.multigrid.post = steady.multigrid.post.value_or(1);
  if (conditions.conserves_mass && !scene.supply)
    scene.supply = [](double) { return std::numeric_limits<double>::infinity(); };
  if (scene.grid.line) {
    scene.deformation.line_unit = unit_of_line * std::max(1.0, steady::contact_size(scene.M, scene.L, scene.shape));
    fmg::RelaxationParameters& relaxation = scene.multigrid.relaxation;
    relaxation.far_squeeze = relaxation.far_squeeze_beside = 0.0;
    relaxation.far_squeeze_of_zone = far_squeeze_of_line;
  }
  return scene;
}

}  // namespace ehl::transient
