#include "transient/scene_in_time.hpp"

#include <algorithm>
#include <limits>

#include "steady/resolution.hpp"

namespace ehl::transient {
namespace {

/// Length at which the logarithm of the line kernel is zero, in contact sizes. Within the pressurised zone, relaxation
/// at constant film would predict a wrong change of H00. [bench: transient_unit_of_line]
constexpr double unit_of_line = 4.0;

/// Change of the film per change of P that Gauss-Seidel relaxation assumes for its neighbourhood, in H per P. The zone
/// of such nodes has a fixed width, so the value must not scale with the cells. Next to the cavitated region there is
/// no such zone and the value is zero. [bench: transient_far_squeeze_of_line]
constexpr double far_squeeze_of_line = 0.2;

}  // namespace

steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions) {
  steady::Scene scene = steady;
  scene.use_symmetry = steady.use_symmetry && symmetric(conditions);
  scene.solver.cycle = steady.solver.cycle.value_or(multigrid::Cycle::V);  // V(2,1) suffices for a predicted state
  scene.solver.pre = steady.solver.pre.value_or(2);
  scene.solver.post = steady.solver.post.value_or(1);
  if (conditions.conserves_mass && !scene.supply)
    scene.supply = [](double) { return std::numeric_limits<double>::infinity(); };
  if (scene.grid.line) {
    scene.deformation.line_unit = unit_of_line * std::max(1.0, steady::contact_size(scene.M, scene.L, scene.shape));
    multigrid::RelaxationParameters& relaxation = scene.solver.relaxation;
    relaxation.far_squeeze = relaxation.far_squeeze_beside = 0.0;
    relaxation.far_squeeze_of_zone = far_squeeze_of_line;
  }
  return scene;
}

}  // namespace ehl::transient
