// Motion of the body above the film.
#include "multigrid/boundary.hpp"
#include "transient/contact_dae.hpp"

namespace ehl::transient {

void ContactDae::release(const Drive& drive) {
  multigrid::Level& level = hierarchy_.finest();
  pose(0.0, drive, 0.0);
  level.P.fill(0.0);
  hierarchy_.H00 = *course_.body->gap;
  V_ = course_.body->velocity;
  hierarchy_.far_motion = {.approach = -V_, .load = 0.0};
  multigrid::update_film(hierarchy_, level);
  multigrid::renew_boundary(hierarchy_, level);
  spread_oil();
}

// Both V = yp_p + cj (H00 - H00_p) and V' (from V by the same formula) are linear in H00, so the load that the film
// must carry is linear in H00 as well.
void ContactDae::move_body(const Stage& stage) {
  const Body& body = *course_.body;
  const double H00 = stage.y_predicted[2 * nodes_];
  const double V = stage.yp_predicted[2 * nodes_];
  const double V_slope = stage.yp_predicted[2 * nodes_ + 1] + stage.cj * (V - stage.y_predicted[2 * nodes_ + 1]);
  hierarchy_.finest().load += W_ * (body.mass * V_slope + body.damping * V);
  hierarchy_.load_line = {W_ * stage.cj * (body.mass * stage.cj + body.damping), H00};
}

// V and V' follow from the load that the film carries, so the equation of motion holds to rounding. The remaining
// algebraic error, and the rounding of H00 amplified by mass cj^2, appears in H00' = V instead.
void ContactDae::take_velocity(const Stage& stage, const Drive& drive) {
  const Body& body = *course_.body;
  const double V_at_rest = stage.y_predicted[2 * nodes_ + 1] - stage.yp_predicted[2 * nodes_ + 1] / stage.cj;
  const double V_slope = (carried() - drive.load - body.damping * V_at_rest) / (body.mass + body.damping / stage.cj);
  V_ = V_at_rest + V_slope / stage.cj;
  multigrid::Level& level = hierarchy_.finest();
  level.load = W_ * (drive.load + body.mass * V_slope + body.damping * V_) - level.load_outside;
  hierarchy_.load_line = {};
}

double ContactDae::acceleration(const Drive& drive) const {
  return (carried() - drive.load - course_.body->damping * V_) / course_.body->mass;
}

}  // namespace ehl::transient
