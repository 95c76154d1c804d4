#include "transient/settle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/start.hpp"
#include "transient/jump.hpp"

namespace ehl::transient {
namespace {

/// Bound of the relative residual of a solved state; below it, a residual that stagnates counts as rounding.
constexpr double hopeless_residual = 1e-5;
/// Largest relative error of the load. Separated bodies without pressure have no residual, only this error.
constexpr double hopeless_load_error = 0.01;
/// Twice the number of cycles that a convergence factor of 1/2 needs from a residual of 1 to settled_residual.
constexpr int most_settling_cycles = 60;
/// If the cycles diverge, they start again with stronger damping, as for the steady solution, and the time steps keep
/// it.
constexpr double less_weight = 0.8;
constexpr double least_weight = 0.5;
/// Cycles per increment of load and speed: they reduce its error enough for the next increment.
/// [bench: transient_cycles_per_bit]
constexpr int cycles_per_bit = 3;

// Residual after at most `most` cycles at T = 0 without squeeze; fewer if it is as small as rounding allows.
double cycles_at_rest(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& drive, int most) {
  dae.pose(0.0, drive, 0.0);
  multigrid::update_film(hierarchy, hierarchy.finest());
  const std::size_t l = hierarchy.levels.size() - 1;
  double residual = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most; ++k) {
    dae.cycle();
    const double now = multigrid::measures_of(hierarchy, l).residual;
    if (!std::isfinite(now)) return now;
    const bool rounding = now < hopeless_residual && now > 0.9 * residual;
    residual = now;
    if (now < settled_residual || rounding) break;
  }
  return residual;
}

// Moves the current state to the steady state at T = 0. returns why that failed; empty if it succeeded.
std::string way_to_rest(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& start) {
  const int bits = bits_between(Drive{}, start);
  double residual = 0.0;
  try {
    for (int k = 1; k <= bits; ++k) {
      const Drive drive = part_of_the_way(Drive{}, start, static_cast<double>(k) / bits);
      residual = cycles_at_rest(hierarchy, dae, drive, k == bits ? most_settling_cycles : cycles_per_bit);
    }
  } catch (const core::SolverError& error) {
    return error.what();
  }
  const double Hm = core::minimum(hierarchy.finest().H).value;
  if (!std::isfinite(residual + Hm)) return "its film or its pressure is not finite";
  if (!(residual < hopeless_residual)) return fmt::format("its relative residual is {:.1e}", residual);
  const double error = dae.load_balance().error;
  if (!(error < hopeless_load_error))
    return fmt::format("the load that it carries is wrong by {:.3g} of the prescribed load", error);
  if (Hm > 0.0) return "";
  return fmt::format("the minimum of its film is negative, H = {:.3g}: the mesh is too coarse; use more cells", Hm);
}

}  // namespace

void settle(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Drive& start) {
  const std::size_t l = hierarchy.levels.size() - 1;
  const multigrid::State from = multigrid::state_of(hierarchy, l);
  std::string reason = way_to_rest(hierarchy, dae, start);
  while (!reason.empty() && less_weight * dae.weight() >= least_weight) {
    dae.set_weight(less_weight * dae.weight());
    multigrid::start_from_state(hierarchy, l, from);
    prepare(hierarchy);
    hierarchy.coarsest_weight = 1.0;
    reason = way_to_rest(hierarchy, dae, start);
  }
  if (!reason.empty())
    throw core::SolverError("the steady solution at the start of the run in time was not found: " + reason);
  dae.balance_load();
}

Checkpoint first_state(multigrid::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions) {
  const Drive drive = drive_at(conditions, 0.0);
  if (conditions.body && conditions.body->gap)
    dae.release(drive);
  else
    settle(hierarchy, dae, drive);
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
