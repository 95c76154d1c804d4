#include "transient/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/start.hpp"
#include "transient/jump.hpp"
#include "transient/quasi_steady.hpp"
#include "transient/snapshot.hpp"

namespace ehl::transient {
namespace {

// Residual after at most `most` cycles at T = 0 without squeeze; fewer if it is as small as rounding allows.
double cycles_at_rest(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& drive, int most) {
  dae.pose(0.0, drive, 0.0);
  multigrid::update_film(hierarchy, hierarchy.finest());
  const std::size_t l = hierarchy.levels.size() - 1;
  const double settled = dae.tuning().settled_residual, solved = hierarchy.parameters.judgement.solved_residual;
  double residual = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most; ++k) {
    dae.cycle();
    const double now = multigrid::measures_of(hierarchy, l).residual;
    if (!std::isfinite(now)) return now;
    const bool rounding = now < solved && now > 0.9 * residual;
    residual = now;
    if (now < settled || rounding) break;
  }
  return residual;
}

// Moves the current state from one drive to the steady state at T = 0. returns why that failed; empty if it succeeded.
std::string way_to_rest(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& from, const Drive& start) {
  const Tuning& tuning = dae.tuning();
  const double distance = std::max({std::abs(start.load - from.load), std::abs(start.speed - from.speed),
                                    std::abs(1.0 / start.radius - 1.0 / from.radius)});
  const int bits = std::max(1, static_cast<int>(std::ceil(distance / tuning.bit_of_start)));
  double residual = 0.0;
  try {
    for (int k = 1; k <= bits; ++k) {
      const Drive drive = part_of_the_way(from, start, static_cast<double>(k) / bits);
      residual = cycles_at_rest(hierarchy, dae, drive, k == bits ? tuning.most_settling_cycles : tuning.cycles_per_bit);
    }
  } catch (const core::SolverError& error) {
    return error.what();
  }
  const double Hm = core::minimum(hierarchy.finest().H).value;
  if (!std::isfinite(residual + Hm)) return "its film or its pressure is not finite";
  if (!(residual < hierarchy.parameters.judgement.solved_residual))
    return fmt::format("its relative residual is {:.1e}", residual);
  const double error = dae.load_balance().error;
  // Separated bodies without pressure have no residual, only this error.
  if (!(error < tuning.hopeless_load_error))
    return fmt::format("the load that it carries is wrong by {:.3g} of the prescribed load", error);
  if (Hm > 0.0) return "";
  return fmt::format("the minimum of its film is negative, H = {:.3g}: the mesh is too coarse; use more cells", Hm);
}

}  // namespace

Drive begin_with(multigrid::Hierarchy& hierarchy, ContactDae& dae, const steady::Scene& scene,
                 const Conditions& conditions) {
  const Drive start = drive_at(conditions, 0.0);
  if (start.load == 1.0 && start.speed == 1.0 && start.radius == 1.0) return {};
  const std::optional<Frame> own = steady_frame(scene, conditions, 0.0);
  if (!own) return {};
  multigrid::Level& level = hierarchy.finest();
  const core::Field P = core::on_patch(level.grid, own->P), H = core::on_patch(level.grid, own->H);
  multigrid::start_from_state(hierarchy, hierarchy.levels.size() - 1, {P, hierarchy.H00});
  prepare(hierarchy);
  dae.pose(0.0, start, 0.0);
  multigrid::update_film(hierarchy, level);
  hierarchy.H00 += judgement::value_at(level.grid, H, 0.0, 0.0) - central_film(level);
  return start;
}

void settle(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& from, const Drive& start) {
  const std::size_t l = hierarchy.levels.size() - 1;
  const multigrid::State before = multigrid::state_of(hierarchy, l);
  std::string reason = way_to_rest(hierarchy, dae, from, start);
  // As for the steady solution: stronger damping if the cycles diverge. The time steps keep it.
  const multigrid::Tuning& damping = hierarchy.parameters.tuning;
  while (!reason.empty() && damping.back_off * dae.weight() >= damping.least_all) {
    dae.set_weight(damping.back_off * dae.weight());
    multigrid::start_from_state(hierarchy, l, before);
    prepare(hierarchy);
    hierarchy.coarsest_weight = 1.0;
    reason = way_to_rest(hierarchy, dae, from, start);
  }
  if (!reason.empty())
    throw core::SolverError("the steady solution at the start of the run in time was not found: " + reason);
  dae.balance_load();
}

namespace {

// The steady state at T = 0 with an effect on the coefficients, by a fixed-point iteration.
void settle_together(multigrid::Hierarchy& hierarchy, ContactDae& dae, Drive from, const Drive& start,
                     const Coupling& coupling) {
  const multigrid::Level& level = hierarchy.finest();
  const Tuning& tuning = dae.tuning();
  // The factors follow the pressure, of which a residual is left.
  const double tolerance = 100.0 * tuning.settled_residual;
  double change = 0.0;
  for (int pass = 0; pass < tuning.most_settling_cycles; ++pass) {
    change = dae.take_factors(coupling.settle(level.grid, level.P, level.H));
    settle(hierarchy, dae, std::exchange(from, start), start);
    if (change <= tolerance) return;
  }
  throw core::SolverError(fmt::format(
      "the steady solution at the start of the run in time was not found: {} still changes the viscosity by "
      "{:.1e} (limit {:.0e})",
      coupling.in_cycles ? "the thinning by the pressure flow" : "the heat", change, tolerance));
}

}  // namespace

Checkpoint first_state(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions,
                       const Drive& from, const Coupling* coupling) {
  const Drive drive = drive_at(conditions, 0.0);
  if (conditions.body && conditions.body->gap)
    dae.release(drive);
  else if (coupling)
    settle_together(hierarchy, dae, from, drive, *coupling);
  else
    settle(hierarchy, dae, from, drive);
  dae.begin_oil();
  Checkpoint start;
  start.y.resize(dae.size());
  start.yp.resize(dae.size(), 0.0);
  dae.state(start.y);
  if (conditions.body) start.yp[2 * dae.nodes() + 1] = dae.acceleration(drive);
  dae.set_state(start.T, drive, start.y, start.yp);
  dae.count_from_here(start.y);
  return start;
}

}  // namespace ehl::transient
