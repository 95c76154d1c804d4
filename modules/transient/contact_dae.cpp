#include "transient/contact_dae.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/boundary.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/cycles.hpp"
#include "multigrid/factors.hpp"
#include "multigrid/mass_balance.hpp"
#include "reynolds/flux.hpp"
#include "transient/nodes.hpp"

namespace ehl::transient {
void prepare(multigrid::Hierarchy& hierarchy) {
  multigrid::Level& level = hierarchy.finest();
  level.f = core::Field(level.grid);
  level.F = core::Field(level.grid);
}

ContactDae::ContactDae(multigrid::Hierarchy& hierarchy, const Course& course, const ErrorControl& control)
    : hierarchy_(hierarchy),
      course_(course),
      control_(control),
      nodes_(static_cast<std::size_t>(hierarchy.finest().grid.nodes_x()) *
             static_cast<std::size_t>(hierarchy.finest().grid.nodes_y())),
      W_(*hierarchy.problem.load),
      V_(course.body ? course.body->velocity : 0.0),
      rate_(control.tuning.best_first_rate),
      P_before_(hierarchy.finest().grid),
      Q_before_(hierarchy.finest().grid),
      stored_share_(hierarchy.finest().grid),
      rho_(nodes_),
      before_(control.coupling != nullptr ? size() : 0),
      now_(before_.size()) {
  const core::Patch& grid = hierarchy.finest().grid;
  for_nodes(grid, [&](int i, int j, std::size_t) { zone_ += in_zone(i, j) ? grid.lines(j) : 0.0; });
  if (!conserves_mass()) return;
  multigrid::update_residual(hierarchy, hierarchy.finest());
  // Where nothing flows aside, the outflow equals the inflow and is the safer measure: if more oil is supplied than
  // passes, the steady film is the flooded one, and the thin supplied layer leaves the domain through the inlet.
  const reynolds::OilBalance flow = multigrid::oil_of(hierarchy, hierarchy.finest());
  inlet_ = reynolds::flows_aside(grid) ? flow.in : flow.out;
}

// The nodes near the contact, which make up the error norm: with equal weights outside the mean would hide the error at
// a dimple.
bool ContactDae::in_zone(int i, int j) const {
  const core::Patch& grid = hierarchy_.levels.back().grid;
  const double radius = control_.tuning.zone_radius;
  return hierarchy_.problem.geometry.outline.at(grid.X(i), grid.Y(j)) <= radius * radius;
}

void ContactDae::state(std::span<double> y) const {
  const multigrid::Level& level = hierarchy_.levels.back();
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) {
    y[k] = level.P(i, j);
    y[nodes_ + k] = content(i, j);
  });
  y[2 * nodes_] = hierarchy_.H00;
  if (course_.body) y[2 * nodes_ + 1] = V_;
  if (conserves_mass()) y.back() = oil_by_flows_;
}

void ContactDae::pose(double T, const Drive& drive, double cj) {
  multigrid::Level& level = hierarchy_.finest();
  reversed_ = drive.speed < 0.0;
  hierarchy_.transport.speed = std::abs(drive.speed);
  hierarchy_.transport.squeeze = cj;
  hierarchy_.sliding = drive.sliding;
  level.load = W_ * drive.load - level.load_outside;
  hierarchy_.load_line = {};
  hierarchy_.outside_line = {};
  hierarchy_.far_motion = {.load = drive.load, .mobility = hierarchy_.far_motion.mobility};
  if (control_.coupling) take_factors(control_.coupling->predict(T));
  level.role = multigrid::Role::solved;
  level.scheme = multigrid::scheme_of(hierarchy_.problem);
  pose_gap(T, drive);
  if (!conserves_mass()) return;
  hierarchy_.supply_factor = drive.supply;
  multigrid::supply_oil(hierarchy_, level);
}

// What reliefs and a varying radius add to the gap, gap_XX (1/radius - 1) X^2 for the radius.
void ContactDae::pose_gap(double T, const Drive& drive) {
  const core::Patch& grid = hierarchy_.finest().grid;
  core::Field& F = hierarchy_.finest().F;
  if (course_.surface) course_.surface(grid, T, F);
  if (course_.surface && reversed_) mirror_in_X(grid, F);
  if (!course_.bends) return;
  if (!course_.surface) F.fill(0.0);
  const double XX = hierarchy_.problem.geometry.gap.XX * (1.0 / drive.radius - 1.0);
  for_nodes(grid, [&](int i, int j, std::size_t) { F(i, j) += XX * grid.X(i) * grid.X(i); });
}

double ContactDae::take_factors(const FilmFactors& factors) {
  multigrid::Level& level = hierarchy_.finest();
  const film::FactorFields& now = factors.coefficients;
  double change = 0.0;
  for_nodes(level.grid, [&](int i, int j, std::size_t) {
    const double mobility = now.fluidity(i, j) * now.mobility(i, j);
    change = std::max(change,
                      std::abs(std::log(mobility / (level.factors->fluidity(i, j) * level.factors->mobility(i, j)))));
    stored_share_(i, j) = factors.stored(i, j) / now.carried(i, j);
  });
  stress_ = factors.stress;
  multigrid::set_factors(hierarchy_, hierarchy_.levels.size() - 1, now);
  return change;
}

void ContactDae::set_state(double T, const Drive& drive, std::span<const double> y, std::span<const double> yp) {
  multigrid::Level& level = hierarchy_.finest();
  pose(T, drive, 0.0);
  if (course_.body) {
    V_ = y[2 * nodes_ + 1];
    if (!yp.empty()) level.load += W_ * (course_.body->mass * yp[2 * nodes_ + 1] + course_.body->damping * V_);
  }
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) { level.P(i, j) = std::max(0.0, y[k]); });
  core::fill_ghosts(level.grid, level.P);
  hierarchy_.H00 = y[2 * nodes_];
  level.H00_of_boundary = hierarchy_.H00;
  take_motion(drive, course_.body ? -V_ : yp.empty() ? 0.0 : -yp[2 * nodes_]);
  multigrid::update_film(hierarchy_, level);
  multigrid::renew_load_outside(hierarchy_, level);
  set_content(y);
}

double ContactDae::carried() const {
  const multigrid::Level& level = hierarchy_.levels.back();
  return (multigrid::carried_load(level) + level.load_outside) / W_;
}

// A moving body is not in equilibrium with the load, so the far field follows the carried load. The rate of change of
// that load is neglected.
void ContactDae::take_motion(const Drive& drive, double approach) {
  const bool imposed = !course_.body;
  hierarchy_.far_motion = {.approach = approach,
                           .load = imposed ? drive.load : carried(),
                           .load_rate = imposed ? drive.load_rate : 0.0,
                           .mobility = hierarchy_.far_motion.mobility};
}

LoadBalance ContactDae::load_balance() const {
  const multigrid::Level& level = hierarchy_.levels.back();
  const double carried_now = multigrid::carried_load(level) + level.load_outside;
  const double wanted = multigrid::wanted_load(hierarchy_, level) + level.load_outside;
  return {carried_now / W_, course_.body ? std::abs(carried_now - wanted) / W_ : std::abs(carried_now / wanted - 1.0)};
}

// The cycles balance the load on the coarsest grid and reduce its error only gradually. The rest is corrected here by a
// common factor 1 + share on P. The deformation grows by the same factor, and H00 is shifted so that the central film
// stays the same: a change of load at almost constant film. If the required load depends on H00 (moving body, closed
// far field), the shift of H00 contributes its part. Deformation = H - rigid gap(H00) - F.
void ContactDae::balance_load() {
  multigrid::Level& level = hierarchy_.finest();
  const core::Patch& grid = level.grid;
  const auto deformation = [&](int i, int j) {
    return level.H(i, j) - multigrid::rigid_gap(hierarchy_.problem.geometry, grid, hierarchy_.H00, i, j) -
           level.F(i, j);
  };
  const int centre = std::clamp(static_cast<int>(std::lround(-grid.domain.X_a / grid.hx())), 0, grid.nx);
  const int axis = std::clamp(static_cast<int>(std::lround(-grid.domain.Y_a / grid.hy())), 0, grid.ny);
  double share = 0.0;
  double yielding = deformation(centre, axis);
  const double slope = hierarchy_.load_line.slope + hierarchy_.outside_line.slope;
  if (course_.body || slope > 0.0) {
    // Bodies that are almost separated hardly deform.
    if (course_.body) yielding = std::max(yielding, control_.tuning.least_yielding);
    const double carried_now = multigrid::carried_load(level);
    share = (multigrid::wanted_load(hierarchy_, level) - carried_now) / (carried_now + slope * yielding);
  } else {
    share = level.load / multigrid::carried_load(level) - 1.0;
  }
  const double shift = share * yielding;
  for_nodes(grid, [&](int i, int j, std::size_t) { level.H(i, j) += share * deformation(i, j) - shift; });
  for (int i = 1; i < grid.nx; ++i)
    for (int j = 1; j <= grid.last_line(); ++j) level.P(i, j) *= 1.0 + share;
  core::fill_ghosts(grid, level.P);
  hierarchy_.H00 -= shift;
  multigrid::follow_H00(hierarchy_, level);
  multigrid::update_coefficients(hierarchy_, level);
}

double ContactDae::least_film(std::span<const double> y) {
  rheology::density(hierarchy_.problem.film.density, y.first(nodes_), rho_);
  double least = std::numeric_limits<double>::infinity();
  const multigrid::Level& level = hierarchy_.levels.back();
  for_nodes(level.grid, reversed_, [&](int i, int j, std::size_t k) {
    const double E = control_.coupling ? stored_share_(i, j) * level.factors->carried(i, j) : 1.0;
    if (!conserves_mass() || y[k] > 0.0) least = std::min(least, y[nodes_ + k] / (E * rho_[k]));
  });
  return least;
}

void ContactDae::weights(std::span<const double> y, std::span<double> w) const {
  const core::Patch& grid = hierarchy_.levels.back().grid;
  // IDA takes the mean over all unknowns. This factor turns it into a mean over the zone of the whole domain, also
  // where the grid covers only half of it, so both grids give the same time steps.
  const double inside = std::sqrt(static_cast<double>(size()) / (2.0 * zone_)) / control_.rtol;
  constexpr double not_tested = 1e-30;  // for unknowns that follow from the others; IDA requires weights above zero
  for_nodes(grid, [&](int i, int j, std::size_t k) {
    const double of_place = in_zone(i, j) ? inside : control_.tuning.weight_outside * inside;
    const double of_node = at_edge(y, i, j) ? control_.tuning.weight_at_edge * of_place : of_place;
    const double factor = std::max(not_tested, std::sqrt(grid.lines(j)) * of_node);
    // The content of an end is given, or follows from its neighbour. It jumps when the flow turns.
    const bool end = conserves_mass() && (i == 0 || i == grid.nx);
    w[k] = factor / (std::abs(y[k]) + control_.P_scale);
    w[nodes_ + k] = end ? not_tested : factor / (std::abs(y[nodes_ + k]) + control_.Q_scale);
  });
  const double of_one = 0.5 * std::sqrt(static_cast<double>(size()));
  w[2 * nodes_] = of_one / (control_.Q_scale * control_.rtol);
  if (conserves_mass()) w.back() = not_tested;
  if (!course_.body) return;
  const double V_scale = std::abs(y[2 * nodes_ + 1]) + natural_frequency(*course_.body) * control_.Q_scale;
  w[2 * nodes_ + 1] = of_one / (V_scale * control_.rtol);
}

}  // namespace ehl::transient
