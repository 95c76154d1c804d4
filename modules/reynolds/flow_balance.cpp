#include "reynolds/flow_balance.hpp"

#include <algorithm>
#include <cmath>

namespace ehl::reynolds {
namespace {

/// Of the place of a node, in cells: one that is meant to be on a limit is within it.
constexpr double rounding = 1e-9;

/// Fluxes per unit of length through the faces around a node.
class Fluxes {
 public:
  Fluxes(const core::Grid& grid, const State& state, Wedge wedge)
      : state_(state), wedge_(wedge), hx_(grid.hx()), hy_(grid.hy()) {}

  /// Along X through the face between i and i+1.
  double along_x(int i, int j) const {
    const double eps = 0.5 * (state_.eps(i, j) + state_.eps(i + 1, j));
    return carried(i, j) - eps * (state_.P(i + 1, j) - state_.P(i, j)) / hx_;
  }
  /// Along Y through the face between j and j+1.
  double along_y(int i, int j) const {
    const double eps = 0.5 * (state_.eps_across(i, j) + state_.eps_across(i, j + 1));
    return -eps * (state_.P(i, j + 1) - state_.P(i, j)) / hy_;
  }
  double rho_H(int i, int j) const { return state_.rho_bar(i, j) * state_.H(i, j); }

 private:
  double carried(int i, int j) const {
    if (wedge_ == Wedge::upstream1) return rho_H(i, j);
    return i == 0 ? 0.5 * (rho_H(0, j) + rho_H(1, j)) : 1.5 * rho_H(i, j) - 0.5 * rho_H(i - 1, j);
  }

  const State& state_;
  Wedge wedge_;
  double hx_, hy_;
};

double flow_through_contact(const core::Grid& grid, const Fluxes& fluxes, double width) {
  const int centre = std::clamp(static_cast<int>(std::lround(-grid.X_a / grid.hx())), 0, grid.nx);
  double sum = 0.0;
  for (int j = 0; j <= grid.ny; ++j)
    if (std::abs(grid.Y(j)) <= width + rounding * grid.hy()) sum += grid.lines(j) * fluxes.rho_H(centre, j);
  return sum * grid.hy();
}

/// The first and the last node inside (-reach, reach) along one direction, the boundary of the grid left out.
struct Range {
  int first, last;
};
Range range(double from, double step, int cells, double reach) {
  const double first = std::ceil((-reach - from) / step - rounding);
  const double last = std::floor((reach - from) / step + rounding);
  return {static_cast<int>(std::max(first, 1.0)), static_cast<int>(std::min(last, cells - 1.0))};
}

bool any_dry(const double* west, const double* P, const double* east, Range y) {
  int dry = 0;
  for (int j = y.first; j <= y.last; ++j) dry |= static_cast<int>((west[j] <= 0.0) | (P[j] <= 0.0) | (east[j] <= 0.0));
  return dry != 0;
}

}  // namespace

FlowBalance flow_balance(const core::Grid& grid, const State& state, Wedge wedge, bool cavitation, const Reach& reach) {
  const Fluxes fluxes(grid, state, wedge);
  const double hx = grid.hx();
  const double hy = grid.hy();
  const Range x = range(grid.X_a, hx, grid.nx, reach.X);
  Range y = range(grid.Y_a, hy, grid.ny, reach.Y);
  if (grid.mirrored) y.last = grid.ny;
  FlowBalance balance;
  balance.through = flow_through_contact(grid, fluxes, reach.width);
  const auto leaves = [&](int j, double flow) {
    (flow < 0.0 ? balance.in : balance.out) += grid.lines(j) * std::abs(flow);
  };
  const int north_end = grid.mirrored ? -1 : y.last;  // there is none at the axis
  for (int i = x.first; i <= x.last; ++i) {
    const double* P = state.P.at_x(i);
    const double* west = state.P.at_x(i - 1);
    const double* east = state.P.at_x(i + 1);
    const auto at = [&](int j) {
      if (cavitation && P[j] <= 0.0) return;
      if (i == x.first || (cavitation && west[j] <= 0.0)) leaves(j, -hy * fluxes.along_x(i - 1, j));
      if (i == x.last || (cavitation && east[j] <= 0.0)) leaves(j, hy * fluxes.along_x(i, j));
      if (j == y.first || (cavitation && P[j - 1] <= 0.0)) leaves(j, -hx * fluxes.along_y(i, j - 1));
      if (j == north_end || (cavitation && P[j + 1] <= 0.0)) leaves(j, hx * fluxes.along_y(i, j));
    };
    // Most stations cross no edge of the cavitated region: there only their two ends count.
    if (i > x.first && i < x.last && y.last > y.first && !(cavitation && any_dry(west, P, east, y))) {
      at(y.first);
      at(y.last);
      continue;
    }
    for (int j = y.first; j <= y.last; ++j) at(j);
  }
  return balance;
}

}  // namespace ehl::reynolds
