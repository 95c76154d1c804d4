#include "transient/snapshot.hpp"

#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/boundary.hpp"

namespace ehl::transient {

double central_film(const multigrid::Level& level) { return judgement::value_at(level.grid, level.H, 0.0, 0.0); }

StepRow row_of(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
               const StepReport& step) {
  const multigrid::Level& level = hierarchy.levels.back();
  const core::Location Hm = core::minimum(level.H);
  const LoadBalance balance = dae.load_balance();
  return {.T = step.T,
          .Hc = central_film(level),
          .Hm = Hm.value,
          .Hm_X = level.grid.X(dae.reversed() ? level.grid.nx - Hm.i : Hm.i),
          .Hm_Y = level.grid.Y(Hm.j),
          .P_max = core::maximum(level.P).value,
          .H00 = hierarchy.H00,
          .load = value(conditions.load, step.T),
          .speed = drive_at(conditions, step.T).speed,
          .radius = value(conditions.radius, step.T),
          .load_error = balance.error,
          .velocity = dae.velocity(),
          .carried = balance.carried,
          .length = step.length,
          .order = step.order,
          .cycles = step.cycles,
          .newton_steps = step.newton_steps,
          .rejected = step.rejected,
          .not_solved = step.not_solved,
          .oil = dae.oil()};
}

Snapshot snapshot_of(const multigrid::Hierarchy& hierarchy, const ContactDae& dae, const Conditions& conditions,
                     double T, const core::Field& P, const core::Field& H) {
  const multigrid::Level& level = hierarchy.levels.back();
  const std::optional<reynolds::FarField>& far_field = hierarchy.problem.far_field;
  return {.T = T,
          .grid = level.grid,
          .P = P,
          .H = H,
          .carried = dae.load_balance().carried,
          .u1 = value(conditions.u1, T),
          .u2 = value(conditions.u2, T),
          .far_field = far_field ? &*far_field : nullptr,
          .far = multigrid::far_state(hierarchy, hierarchy.H00),
          .factors = level.factors ? &*level.factors : nullptr,
          .stress = dae.stress().nodes_x() > 0 ? &dae.stress() : nullptr};
}

}  // namespace ehl::transient
