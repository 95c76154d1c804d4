#include "multigrid/mass_balance.hpp"

#include <algorithm>
#include <cmath>

#include "core/norms.hpp"
#include "judgement/measures.hpp"
#include "multigrid/relaxation.hpp"

namespace ehl::multigrid {
namespace {

/// Implicit time step: largest further defect, over squeeze times all of the stored oil.
constexpr double rounding = 1e-15;

bool lacks(const Hierarchy& hierarchy, const Level& level, int i, int j) {
  return !reynolds::stays_dry(hierarchy.problem.cavitation, level.P(i, j), level.r(i, j));
}

/// A line of states: P + t dP, H + t dH, H00 + t dH00, with t from least to most.
struct SearchDirection {
  core::Field dP{};  ///< empty: H00 alone moves
  core::Field dH{};
  double dH00 = 0.0;
  double first = 0.0;  ///< first step
  double least = 0.0, most = 0.0;
};

// The line from this state back to an earlier one, whose defect is larger and has the other sign. Between them no
// pressure is negative, and cavitated nodes stay so.
SearchDirection direction_back_to(const State& before, Hierarchy& hierarchy, Level& level) {
  SearchDirection direction{.dP = core::Field(level.grid),
                            .dH = core::Field(level.grid),
                            .dH00 = hierarchy.H00 - before.H00,
                            .first = -0.5,
                            .least = -1.0};
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j)
      direction.dP(i, j) = level.P(i, j) > 0.0 ? level.P(i, j) - before.P(i, j) : 0.0;
  core::fill_ghosts(level.grid, direction.dP);
  const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
  level.deformation.evaluate(direction.dP, direction.dH);
  ++level.evaluations;
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j) direction.dH(i, j) += direction.dH00;
  return direction;
}

// The line of states with a factor on the pressure of the inlet, at the same load. It acts on small pressures, which
// contribute little to the load and to the deformation. It comes before the correction by the film, which alone moves
// the film too far.
SearchDirection direction_of_inlet(Hierarchy& hierarchy, Level& level) {
  const Tuning& tuning = hierarchy.parameters.tuning;
  SearchDirection direction{.dP = core::Field(level.grid),
                            .dH = core::Field(level.grid),
                            .first = tuning.inlet_factor,
                            .least = -1.0,
                            .most = 1.0};
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) {
      const double P = level.P(i, j);
      const double relative = P / tuning.inlet_pressure;
      direction.dP(i, j) = P / (1.0 + relative * relative);
    }
  const double share = core::interior_sum(level.grid, direction.dP) / core::interior_sum(level.grid, level.P);
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j) direction.dP(i, j) -= share * level.P(i, j);
  core::fill_ghosts(level.grid, direction.dP);
  const core::ScopedTimer timer(hierarchy.times, core::Part::deformation);
  level.deformation.evaluate(direction.dP, direction.dH);
  ++level.evaluations;
  return direction;
}

// Derivative of the mass defect by the film thickness, nearly: outflow where the pressure ends, storage in every full
// node.
double defect_per_film(const Hierarchy& hierarchy, const Level& level) {
  const core::Patch& grid = level.grid;
  double lines = 0.0, nodes = 0.0;
  for (int j = 1; j <= grid.last_line(); ++j) {
    double full = 0.0;
    for (int i = 1; i < grid.nx; ++i) full += lacks(hierarchy, level, i, j) ? level.rho_bar(i, j) : 0.0;
    nodes += grid.lines(j) * full;
    lines += full > 0.0 ? grid.lines(j) : 0.0;
  }
  return grid.hy() * (hierarchy.transport.speed * lines + hierarchy.transport.squeeze * grid.hx() * nodes);
}

SearchDirection direction_of_film(const Hierarchy& hierarchy, const Level& level, double excess) {
  const double Hc = judgement::value_at(level.grid, level.H, 0.0, 0.0);
  const double most = std::abs(Hc);
  return {.dH00 = 1.0, .first = -excess / defect_per_film(hierarchy, level), .least = -most, .most = most};
}

void move_along(Hierarchy& hierarchy, Level& level, const SearchDirection& direction, double t) {
  const core::Patch& grid = level.grid;
  hierarchy.H00 += t * direction.dH00;
  for (int i = 0; i <= grid.nx; ++i) {
    for (int j = 0; j <= grid.ny; ++j)
      level.H(i, j) += t * (direction.dP.nodes_x() > 0 ? direction.dH(i, j) : direction.dH00);
    if (direction.dP.nodes_x() == 0) continue;
    for (int j = 0; j <= grid.ny; ++j) level.P(i, j) += t * direction.dP(i, j);
    core::fill_ghosts(grid, level.P.at_x(i));
  }
  update_coefficients(hierarchy, level);
  update_residual(hierarchy, level);
}

// Secant method along a line of states, as long as the defect falls; the first step only measures its derivative.
// out: true if the oil balances; else the state is as before.
bool balanced_along(Hierarchy& hierarchy, Level& level, const SearchDirection& direction, double enough) {
  double excess = mass_defect(hierarchy, level);
  double t = 0.0, step = direction.first;
  bool falls = true;
  while (falls && std::abs(excess) > enough && t + step >= direction.least && t + step <= direction.most) {
    move_along(hierarchy, level, direction, step);
    falls = t == 0.0;
    t += step;
    const double now = mass_defect(hierarchy, level);
    falls = falls || std::abs(now) < std::abs(excess);
    step *= now / (excess - now);
    excess = now;
  }
  if (std::abs(excess) <= enough) return true;
  move_along(hierarchy, level, direction, -t);
  return false;
}

}  // namespace

reynolds::OilBalance oil_of(const Hierarchy& hierarchy, const Level& level) {
  return reynolds::oil_balance(level.grid, fields(level), transport_on(hierarchy, level));
}

core::Field theta_of(const Level& level) {
  core::Field theta(level.grid);
  for (int i = 0; i <= level.grid.nx; ++i)
    for (int j = 0; j <= level.grid.ny; ++j)
      theta(i, j) = level.content->Q(i, j) / (level.rho_bar(i, j) * level.H(i, j));
  return theta;
}

double stored_oil(const Level& level) {
  return level.grid.hx() * level.grid.hy() * core::interior_sum(level.grid, level.content->Q);
}

double mass_defect(const Hierarchy& hierarchy, const Level& level) {
  double sum = 0.0;
  for (int i = 1; i < level.grid.nx; ++i)
    for (int j = 1; j <= level.grid.last_line(); ++j)
      sum += lacks(hierarchy, level, i, j) ? level.grid.lines(j) * level.r(i, j) : 0.0;
  return level.grid.hx() * level.grid.hy() * sum;
}

bool balance_mass(Hierarchy& hierarchy, Level& level, std::optional<double> flow) {
  if (!conserves_mass(level)) return false;
  update_residual(hierarchy, level);
  const double enough = hierarchy.parameters.tuning.balanced_oil * flow.value_or(oil_of(hierarchy, level).in) +
                        rounding * hierarchy.transport.squeeze * stored_oil(level);
  const double excess = mass_defect(hierarchy, level);
  if (std::abs(excess) <= enough) return false;
  const bool steady = !(hierarchy.transport.squeeze > 0.0) && carried_load(level) > 0.0;
  if (steady && balanced_along(hierarchy, level, direction_of_inlet(hierarchy, level), enough)) return true;
  return balanced_along(hierarchy, level, direction_of_film(hierarchy, level, excess), enough);
}

bool correct_mass(Hierarchy& hierarchy, Level& level, const State& before, const RelaxationParameters& relaxation) {
  update_residual(hierarchy, level);
  const double enough = hierarchy.parameters.tuning.balanced_oil * oil_of(hierarchy, level).in;
  if (std::abs(mass_defect(hierarchy, level)) <= enough) return false;
  if (balanced_along(hierarchy, level, direction_back_to(before, hierarchy, level), enough)) return true;
  if (!balance_mass(hierarchy, level)) return false;
  relax(hierarchy, level, relaxation);
  balance_mass(hierarchy, level);
  return true;
}

}  // namespace ehl::multigrid
