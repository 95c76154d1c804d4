#include "multigrid/start.hpp"

#include <algorithm>
#include <cmath>

#include "multigrid/boundary.hpp"
#include "multigrid/chattering.hpp"
#include "multigrid/cycle.hpp"
#include "multigrid/relaxation.hpp"
#include "transfer/transfer.hpp"

namespace ehl::multigrid {
namespace {

/// With epsilon at half points the line systems contain the derivatives of the viscosity, and diverge far from the
/// solution, as Newton's method does. So the first steps on a grid use the mean of the nodes: some cycles from the
/// Hertz pressure, or the relaxations after an interpolation.

template <class Steps>
void begin_with_mean(Hierarchy& hierarchy, Level& level, Steps steps) {
  if (!at_half_points(level)) return;
  level.scheme = coarse_scheme_of(hierarchy.problem);
  update_coefficients(hierarchy, level);
  steps();
  level.scheme = scheme_of(hierarchy.problem);
  update_coefficients(hierarchy, level);
}

void pose_original_problem(const Hierarchy& hierarchy, Level& level) {
  const Problem& problem = hierarchy.problem;
  level.f.fill(0.0);
  if (problem.surface)
    problem.surface(level.grid, level.F);
  else
    level.F.fill(0.0);
  level.role = Role::solved;
  level.scheme = scheme_of(problem);
  level.load = problem.load.value_or(0.0);
  level.load_outside = 0.0;
  if (level.touching) level.touching->yielded.fill(0.0);
  forget_chattering(level);
  supply_oil(hierarchy, level);
}

// The mean of S, weighted with the pressure.
double mean_surface(const Level& level) {
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double weight = level.grid.lines(j) * level.P(i, j);
      sum += weight * level.F(i, j);
      weights += weight;
    }
  return weights > 0.0 ? sum / weights : 0.0;
}

/// The far field of rigid bodies without cavitation (reynolds/far_field.hpp has the one with it), P = -(c_X X + c_Y
/// Y)/H^2: with the undeformed gap H = x A x, div(H^3 grad P) = lambda dH/dX gives (A + 2 tr(A)) c = lambda A e_X.
class UnrupturedField {
 public:
  UnrupturedField(const core::QuadraticForm& gap, double lambda) : gap_(gap) {
    const double b = 0.5 * gap.XY;
    const double trace = gap.XX + gap.YY;
    const double XX = gap.XX + 2.0 * trace;
    const double YY = gap.YY + 2.0 * trace;
    const double scale = lambda / (XX * YY - b * b);
    c_X_ = scale * (YY * gap.XX - b * b);
    c_Y_ = scale * (XX * b - b * gap.XX);
  }
  double P(double X, double Y) const {
    const double H = gap_.at(X, Y);
    return -(c_X_ * X + c_Y_ * Y) / (H * H);
  }

 private:
  core::QuadraticForm gap_;
  double c_X_, c_Y_;
};

/// 1 at the origin, falling to zero on the boundary, where the pressure is zero.
double taper(const core::Grid& domain, double X, double Y) {
  const double x = X / (X < 0.0 ? domain.X_a : domain.X_b);
  const double y = Y / (Y < 0.0 ? domain.Y_a : domain.Y_b);
  return (1.0 - x * x) * (1.0 - y * y);
}

// Initial pressure outside an elliptic contact. The film ruptures far from the contact and not along a line of constant
// X. In relaxations an edge of the pressure advances by one cell per sweep, but recedes by any number of cells. So it
// starts too far downstream, with the far field's pressure everywhere, its sign reversed where that is negative.
// Near the contact the far field is no estimate. in: most, the largest pressure.
void begin_outside(const Problem& problem, double most, Level& level) {
  const UnrupturedField far(problem.geometry.gap, problem.film.lambda);
  const core::Grid& domain = level.grid.domain;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double X = level.grid.X(i);
      const double Y = level.grid.Y(j);
      const bool outside = problem.geometry.outline.at(X, Y) >= 1.0;
      if (outside || level.P(i, j) == 0.0) {
        const double P = outside ? std::min(std::abs(far.P(X, Y)), most) : most;
        level.P(i, j) = std::max(level.P(i, j), P * taper(domain, X, Y));
      }
    }
}

// Starts from the pressure of the dry contact, and that of the oil around it. out: H00 of the dry contact.
double begin_dry(const Problem& problem, double most, Level& level) {
  const double H00 = problem.dry(level.grid, level.P);
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j)
      if (i == 0 || j == 0 || i == level.grid.nx || j > level.grid.last_line()) level.P(i, j) = 0.0;
  begin_outside(problem, most, level);
  return H00;
}

}  // namespace

void start_from_hertz(Hierarchy& hierarchy, std::size_t l, double H00, int sweeps, const Parameters& how) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy, level);
  const auto& [XX, XY, YY] = hierarchy.problem.geometry.outline;
  const std::optional<reynolds::FarField>& far_field = hierarchy.problem.far_field;
  // Rigid bodies that do not touch: the far field extends to the centre.
  const bool apart = far_field && H00 > 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double X = level.grid.X(i);
      const double Y = level.grid.Y(j);
      const double inside = 1.0 - XX * X * X - (XY * X + YY * Y) * Y;
      // Where the viscosity rises too fast for rigid bodies (no P): the largest Hertz pressure.
      if (const double P =
              apart ? far_field->P(X, Y, rigid_gap(hierarchy.problem.geometry, level.grid, H00, i, j)) : 0.0;
          apart)
        level.P(i, j) = P < 1.0 ? P : 1.0;
      else
        level.P(i, j) = inside > 0.0 ? std::sqrt(inside) : 0.0;
    }
  const double most_outside = hierarchy.parameters.tuning.pressure_outside;
  if (hierarchy.problem.dry)
    H00 += begin_dry(hierarchy.problem, most_outside, level);
  else if (!apart && !hierarchy.problem.geometry.gap.round())
    begin_outside(hierarchy.problem, most_outside, level);
  core::fill_ghosts(level.grid, level.P);
  hierarchy.H00 = hierarchy.problem.surface && !hierarchy.problem.dry ? H00 - mean_surface(level) : H00;
  update_film(hierarchy, level);
  renew_boundary(hierarchy, level);
  // X sweeps alone: this far from a solution Y sweeps on stretched cells lead away from it.
  const auto relax_alone = [&] {
    for (int sweep = 1; sweep <= sweeps; ++sweep) {
      if (sweep % hierarchy.parameters.tuning.sweeps_per_balance == 0) {
        relax_with_force_balance(hierarchy, level, 1, how);
      } else {
        relax_pressure(hierarchy, level, how.relaxation);
        update_film(hierarchy, level);
      }
    }
  };
  if (sweeps == 0) return;
  if (!at_half_points(level)) return relax_alone();
  begin_with_mean(hierarchy, level, [&] {
    relax_alone();
    for (int cycle = 0; cycle < hierarchy.parameters.tuning.cycles_from_hertz; ++cycle) fas_cycle(hierarchy, l, how);
  });
}

void start_from_state(Hierarchy& hierarchy, std::size_t l, const State& start) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy, level);
  core::copy(start.P, level.P);
  core::fill_ghosts(level.grid, level.P);
  if (level.touching) {
    level.touching->P_c.fill(0.0);
    if (start.P_c.nodes_x() > 0) core::copy(start.P_c, level.touching->P_c);
  }
  hierarchy.H00 = start.H00;
  update_film(hierarchy, level);
  renew_boundary(hierarchy, level);
}

void start_from_coarser(Hierarchy& hierarchy, std::size_t l) {
  Level& level = hierarchy.levels[l];
  pose_original_problem(hierarchy, level);
  const Level& below = hierarchy.levels[l - 1];
  const auto interpolate = [&](const core::Field& coarse, core::Field& P, reynolds::Cavitation cavitation) {
    const core::ScopedTimer timer(hierarchy.times, core::Part::transfer);
    transfer::prolong_bicubic(below.grid, coarse, P);
    for (int i = 0; i <= level.grid.nx; ++i)
      for (int j = 0; j <= level.grid.ny; ++j) {
        const bool boundary = i == 0 || j == 0 || i == level.grid.nx || j > level.grid.last_line();
        P(i, j) = boundary ? 0.0 : reynolds::projected(cavitation, P(i, j));
      }
    core::fill_ghosts(level.grid, P);
  };
  interpolate(below.P, level.P, hierarchy.problem.cavitation);
  if (level.touching) interpolate(below.touching->P_c, level.touching->P_c, reynolds::Cavitation::nonnegative_pressure);
  update_film(hierarchy, level);
  renew_boundary(hierarchy, level);
  begin_with_mean(hierarchy, level, [&] {
    const Parameters& parameters = hierarchy.parameters;
    const RelaxationParameters relaxation = lighter(parameters.relaxation, parameters.settling_weight);
    for (int sweep = 0; sweep < parameters.settling_sweeps; ++sweep) relax(hierarchy, level, relaxation);
  });
}

void start_from_two_coarser(Hierarchy& hierarchy, std::size_t l, const State& two_below, double order) {
  const double weight = std::exp2(-order);
  Level& below = hierarchy.levels[l - 1];
  core::Field coarser(below.grid);
  transfer::prolong_bicubic(hierarchy.levels[l - 2].grid, two_below.P, coarser);
  // The cavitated region is that of the finer solution.
  for (int i = 1; i < below.grid.nx; ++i)
    for (int j = 1; j <= below.grid.last_line(); ++j) {
      double& P = below.P(i, j);
      if (P > 0.0) P = std::max(0.0, P + weight * (P - coarser(i, j)));
    }
  hierarchy.H00 += weight * (hierarchy.H00 - two_below.H00);
  start_from_coarser(hierarchy, l);
}

}  // namespace ehl::multigrid
