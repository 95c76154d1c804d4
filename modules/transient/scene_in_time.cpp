#include "transient/scene_in_time.hpp"

#include <algorithm>
#include <limits>

#include "steady/multigrid_solve.hpp"

namespace ehl::transient {

steady::Scene scene_in_time(const steady::Scene& steady, const Conditions& conditions) {
  steady::Scene scene = steady;
  scene.use_symmetry = steady.use_symmetry && symmetric(conditions);
  scene.solver.cycle = steady.solver.cycle.value_or(multigrid::Cycle::V);  // V(2,1) suffices for a predicted state
  scene.solver.pre = steady.solver.pre.value_or(2);
  scene.solver.post = steady.solver.post.value_or(1);
  if (conditions.conserves_mass && !scene.supply)
    scene.supply = [](double) { return std::numeric_limits<double>::infinity(); };
  if (scene.thinning) scene.thinning->k = conditions.thinning_k;
  if (steady::geometry_of(scene).kernel.plane) {
    // Within the pressurised zone, relaxation at constant film would predict a wrong change of H00.
    scene.deformation.line_unit = conditions.tuning.unit_of_line * std::max(1.0, scene.contact.size);
    multigrid::RelaxationParameters& relaxation = scene.solver.relaxation;
    // The zone of single points has a fixed width, so the value must not scale with the cells. Next to the cavitated
    // region there is no such zone and the value is zero.
    relaxation.far_squeeze = relaxation.far_squeeze_beside = 0.0;
    relaxation.far_squeeze_of_zone = conditions.tuning.far_squeeze_of_line;
  }
  return scene;
}

double shift_of_unit(const steady::Scene& scene) {
  const kernel::Kernel kernel = steady::geometry_of(scene).kernel;
  if (!kernel.plane) return 0.0;
  return -kernel.factor * contact::load(scene.contact.shape) * kernel::at_distance(kernel, scene.deformation.line_unit);
}

}  // namespace ehl::transient
