#include "multigrid/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"
#include "core/norms.hpp"
#include "multigrid/boundary_extension.hpp"
#include "multigrid/line_contact.hpp"
#include "reynolds/flow_balance.hpp"

namespace ehl::multigrid {
namespace {

// Calls action(i, j, share) at the boundary nodes; share is the part of the node's cell inside the domain.
template <class Action>
void for_boundary(const core::Patch& grid, Action action) {
  if (grid.domain.line) {
    for (const int i : {0, grid.nx}) action(i, 1, 0.5);
    return;
  }
  const bool north = grid.north == core::Edge::zero;
  for (const int i : {0, grid.nx}) {
    action(i, 0, 0.25);
    for (int j = 1; j <= grid.last_line(); ++j) action(i, j, 0.5);
    if (north) action(i, grid.ny, 0.25);
  }
  for (int i = 1; i < grid.nx; ++i) {
    action(i, 0, 0.5);
    if (north) action(i, grid.ny, 0.5);
  }
}

// The flow where the pressure is largest and epsilon smallest.
double flow_through_line(const Hierarchy& hierarchy, const Level& level) {
  const int top = core::maximum(level.P).i;
  const int i = std::clamp(top, 1, level.grid.nx - 2);
  return reynolds::flow_along(level.grid, fields(level), transport_on(hierarchy, level), i, 1);
}

// Factor on epsilon upstream. The same flow builds up a pressure that is smaller by this factor.
double mobility_upstream(const Hierarchy& hierarchy, const Level& level) {
  if (!along_one_line(hierarchy, level) || !level.factors) return 1.0;
  return std::pow(level.factors->fluidity(0, 1) * level.factors->mobility(0, 1), reynolds::share_upstream);
}

// The film without the surface relief.
double smooth_film(const Level& level, int i, int j) {
  return level.H(i, j) - (level.F.nodes_x() > 0 ? level.F(i, j) : 0.0);
}

}  // namespace

reynolds::FarState far_state(const Hierarchy& hierarchy, double H00) {
  const FarMotion& motion = hierarchy.far_motion;
  return {.H00 = H00,
          .speed = hierarchy.transport.speed / motion.mobility,
          .approach = motion.approach - motion.slope * (H00 - motion.origin),
          .load = motion.load,
          .load_rate = motion.load_rate,
          .flow = motion.flow};
}

std::vector<reynolds::FarPoint> points_of_boundary(const Problem& problem, const core::Patch& grid) {
  std::vector<reynolds::FarPoint> points;
  if (problem.far_field)
    for_boundary(grid, [&](int i, int j, double) { points.push_back(problem.far_field->at(grid.X(i), grid.Y(j))); });
  return points;
}

std::vector<BoundaryNode> nodes_of_boundary(const core::Patch& grid) {
  std::vector<BoundaryNode> nodes;
  for_boundary(grid, [&](int i, int j, double share) { nodes.push_back({i, j, share}); });
  return nodes;
}

FarSlopes far_slopes(const Hierarchy& hierarchy, const Level& level) {
  const reynolds::FarField& far_field = *hierarchy.problem.far_field;
  constexpr double step = 1e-5;  // about the cube root of rounding, for films of order one
  const auto slope = [&](auto value) { return (value(step) - value(-step)) / (2.0 * step); };
  const auto state = [&](double more) { return far_state(hierarchy, hierarchy.H00 + more); };
  FarSlopes slopes;
  auto point = level.boundary.begin();
  for_boundary(level.grid, [&](int i, int j, double) {
    const double H = smooth_film(level, i, j);
    slopes.P_by_H.push_back(slope([&](double d) { return far_field.P(*point, H + d, state(0.0)); }));
    slopes.P_by_H00.push_back(slope([&](double d) { return far_field.P(*point, H, state(d)); }));
    ++point;
  });
  slopes.load_by_H00 = slope([&](double d) { return far_field.load_outside(state(d)); });
  return slopes;
}

double renew_load_outside(Hierarchy& hierarchy, Level& level) {
  if (!hierarchy.problem.far_field) return 0.0;
  const reynolds::FarField& far_field = *hierarchy.problem.far_field;
  const core::Patch& grid = level.grid;
  double sum = 0.0;
  for_boundary(grid, [&](int i, int j, double share) { sum += grid.lines(j) * share * level.P(i, j); });
  const reynolds::FarState state = far_state(hierarchy, hierarchy.H00);
  const double beyond = far_field.load_outside(state);
  const double outside = beyond + grid.hx() * grid.hy() * sum;
  if (!std::isfinite(outside))
    throw core::SolverError(
        "on the boundary of the domain the film is too thin for the closed far field: use a larger domain");
  hierarchy.outside_line = {};
  if (hierarchy.far_motion.slope > 0.0) {
    constexpr double faster = 1e-4;
    reynolds::FarState ahead = state;
    ahead.approach += faster;
    const double per_speed = (far_field.load_outside(ahead) - beyond) / faster;
    hierarchy.outside_line = {.slope = hierarchy.far_motion.slope * per_speed, .origin = hierarchy.H00};
  }
  const double more = outside - level.load_outside;
  level.load -= more;
  level.load_outside = outside;
  return std::abs(more / hierarchy.problem.load.value_or(1.0));
}

double renew_boundary(Hierarchy& hierarchy, Level& level) {
  if (!hierarchy.problem.far_field) return 0.0;
  const reynolds::FarField& far_field = *hierarchy.problem.far_field;
  if (!hierarchy.problem.geometry.gap.closed()) {
    hierarchy.far_motion.flow = flow_through_line(hierarchy, level);
    hierarchy.far_motion.mobility = mobility_upstream(hierarchy, level);
  }
  const reynolds::FarState state = far_state(hierarchy, hierarchy.H00);
  double change = 0.0;
  auto point = level.boundary.begin();
  for_boundary(level.grid, [&](int i, int j, double) {
    const double P = far_field.P(*point++, smooth_film(level, i, j), state);
    change = std::max(change, std::abs(P - level.P(i, j)));
    level.P(i, j) = P;
  });
  core::fill_ghosts(level.grid, level.P);
  level.H00_of_boundary = hierarchy.H00;
  return std::max(change, renew_load_outside(hierarchy, level));
}

void renew_boundary_and_inside(Hierarchy& hierarchy, Level& level) {
  if (!hierarchy.parameters.extend_boundary) {
    renew_boundary(hierarchy, level);
    return;
  }
  if (!hierarchy.problem.far_field) return;
  core::Field& change = level.correction;
  for_boundary(level.grid, [&](int i, int j, double) { change(i, j) = -level.P(i, j); });
  renew_boundary(hierarchy, level);
  for_boundary(level.grid, [&](int i, int j, double) { change(i, j) += level.P(i, j); });
  extend_boundary(hierarchy, level);
}

void follow_H00(const Hierarchy& hierarchy, Level& level) {
  if (!hierarchy.problem.far_field || !(hierarchy.far_motion.slope > 0.0)) return;
  const reynolds::FarField& far_field = *hierarchy.problem.far_field;
  const reynolds::FarState before = far_state(hierarchy, level.H00_of_boundary);
  const reynolds::FarState now = far_state(hierarchy, hierarchy.H00);
  const bool restricted = corrects_finer(level);
  auto point = level.boundary.begin();
  for_boundary(level.grid, [&](int i, int j, double) {
    const double H = restricted ? level.finer->H(i, j) : smooth_film(level, i, j);
    const double change = far_field.P(*point, H, now) - far_field.P(*point, H, before);
    level.P(i, j) = std::max(0.0, level.P(i, j) + change);
    ++point;
  });
  core::fill_ghosts(level.grid, level.P);
  level.H00_of_boundary = hierarchy.H00;
}

}  // namespace ehl::multigrid
