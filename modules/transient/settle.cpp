#include "transient/settle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "fmg/boundary.hpp"
#include "fmg/cycle.hpp"
#include "fmg/cycles.hpp"
#include "transient/jump.hpp"

namespace ehl::transient {
namespace {

/// Above it no state counts as solved, and no stalling residual as rounding.
constexpr double hopeless_residual = 1e-5;
/// Twice what cycles that halve the residual take from one to settled_residual.
constexpr int most_settling_cycles = 60;
/// A V(2,1) cycle leaves 0.1 to 0.3 of the error: three leave 3 % of a bit at most, for the next one to begin with.
constexpr int cycles_per_bit = 3;

// Residual after cycles at T = 0 without squeeze: `most` of them, or fewer where it is as small as rounding allows.
double cycles_at_rest(fmg::Hierarchy& hierarchy, ContactDae& dae, const Drive& drive, int most) {
  dae.pose(0.0, drive, 0.0);
  fmg::update_film(hierarchy, hierarchy.finest());
  const std::size_t l = hierarchy.levels.size() - 1;
  double residual = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most; ++k) {
    fmg::fas_cycle(hierarchy, l);
    fmg::renew_boundary(hierarchy, hierarchy.finest());
    const double now = fmg::measures_of(hierarchy, l).residual;
    if (!std::isfinite(now)) return now;
    const bool rounding = now < hopeless_residual && now > 0.9 * residual;
    residual = now;
    if (now < settled_residual || rounding) break;
  }
  return residual;
}

core::SolverError not_found(const std::string& reason) {
  return core::SolverError("the steady state at the start of the transient was not found: " + reason);
}

}  // namespace

void settle(fmg::Hierarchy& hierarchy, ContactDae& dae, const Drive& start) {
  const int bits = bits_between(Drive{}, start);
  double residual = 0.0;
  for (int k = 1; k <= bits; ++k) {
    const Drive drive = part_of_the_way(Drive{}, start, static_cast<double>(k) / bits);
    residual = cycles_at_rest(hierarchy, dae, drive, k == bits ? most_settling_cycles : cycles_per_bit);
  }
  const double Hm = core::minimum(hierarchy.finest().H).value;
  if (!std::isfinite(residual + Hm)) throw not_found("its film or its pressure is not finite");
  if (!(residual < hopeless_residual)) throw not_found(fmt::format("its relative residual is {:.1e}", residual));
  if (!(Hm > 0.0))
    throw not_found(fmt::format("its film is negative at its thinnest, H = {:.3g}: the mesh is too coarse for it", Hm));
  dae.balance_load();
}

Checkpoint first_state(fmg::Hierarchy& hierarchy, ContactDae& dae, const Conditions& conditions) {
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
