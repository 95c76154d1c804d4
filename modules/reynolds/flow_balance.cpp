#include "reynolds/flow_balance.hpp"

#include <algorithm>
#include <cmath>

#include "reynolds/content.hpp"

namespace ehl::reynolds {
namespace {

/// Tolerance for the position of a node, in cells: a node that is meant to be on a limit counts as within it.
constexpr double rounding = 1e-9;

/// Fluxes per unit of length through the faces around a node.
class Fluxes {
 public:
  Fluxes(const core::Patch& grid, const Fields& state, const Transport& transport)
      : state_(state), transport_(transport), hx_(grid.hx()), hy_(grid.hy()) {}

  /// Along X through the face between i and i+1.
  double along_x(int i, int j) const {
    const double eps = conductance(state_.face, state_.eps(i, j), state_.eps(i + 1, j), 0.5);
    return transport_.speed * carried_behind(i, j) - eps * (state_.P(i + 1, j) - state_.P(i, j)) / hx_;
  }
  /// Along Y through the face between j and j+1.
  double along_y(int i, int j) const {
    const double eps = conductance(state_.face, state_.eps_across(i, j), state_.eps_across(i, j + 1), 0.5);
    return -eps * (state_.P(i, j + 1) - state_.P(i, j)) / hy_;
  }
  double rho_H(int i, int j) const { return state_.rho_bar(i, j) * state_.H(i, j); }

 private:
  // What the film carries through the face between i and i+1, over U.
  double carried_behind(int i, int j) const {
    const auto full = [&](int k) { return rho_H(k, j); };
    if (state_.content != nullptr)
      return carried_content(
          transport_.wedge, i, [&](int k) { return (*state_.content)(k, j); }, full,
          third_order(transport_.wedge) ? state_.third_order(i, j) : 0.0, first_order_behind(state_, i - 1, j));
    double Q = carried(transport_.wedge, i, full);
    if (third_order(transport_.wedge) && i > 0)
      Q += third_order_part(state_.third_order(i, j), rho_H(i - 1, j), rho_H(i, j), rho_H(i + 1, j));
    return Q;
  }

  const Fields& state_;
  const Transport& transport_;
  double hx_, hy_;
};

double flow_through_contact(const core::Patch& grid, const Fluxes& fluxes, double width) {
  const int centre = std::clamp(static_cast<int>(std::lround(-grid.domain.X_a / grid.hx())), 0, grid.nx);
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

bool any_dry(Cavitation cavitation, const double* west, const double* P, const double* east, Range y) {
  for (int j = y.first; j <= y.last; ++j)
    if (dry(cavitation, west[j]) || dry(cavitation, P[j]) || dry(cavitation, east[j])) return true;
  return false;
}

}  // namespace

double flow_along(const core::Patch& grid, const Fields& state, const Transport& transport, int i, int j) {
  return Fluxes(grid, state, transport).along_x(i, j);
}

FlowBalance flow_balance(const core::Patch& grid, const Fields& state, const Transport& transport,
                         Cavitation cavitation, const Reach& reach) {
  const Fluxes fluxes(grid, state, transport);
  const double hx = grid.hx();
  const double hy = grid.hy();
  const Range x = range(grid.domain.X_a, hx, grid.nx, reach.X);
  Range y = range(grid.domain.Y_a, hy, grid.domain.ny, reach.Y);
  const bool goes_on = y.last > grid.last_line();  // beyond the last line, by symmetry
  y.last = std::min(y.last, grid.last_line());
  FlowBalance balance;
  balance.through = flow_through_contact(grid, fluxes, reach.width);
  const auto leaves = [&](int j, double flow) {
    (flow < 0.0 ? balance.in : balance.out) += grid.lines(j) * std::abs(flow);
  };
  const int north_end = goes_on ? -1 : y.last;
  for (int i = x.first; i <= x.last; ++i) {
    const double* P = state.P.at_x(i);
    const double* west = state.P.at_x(i - 1);
    const double* east = state.P.at_x(i + 1);
    const auto at = [&](int j) {
      if (dry(cavitation, P[j])) return;
      if (i == x.first || dry(cavitation, west[j])) leaves(j, -hy * fluxes.along_x(i - 1, j));
      if (i == x.last || dry(cavitation, east[j])) leaves(j, hy * fluxes.along_x(i, j));
      if (j == y.first || dry(cavitation, P[j - 1])) leaves(j, -hx * fluxes.along_y(i, j - 1));
      if (j == north_end || dry(cavitation, P[j + 1])) leaves(j, hx * fluxes.along_y(i, j));
    };
    // Most columns cross no edge of the cavitated region. There only their two end nodes count.
    if (i > x.first && i < x.last && y.last > y.first && !any_dry(cavitation, west, P, east, y)) {
      at(y.first);
      at(y.last);
      continue;
    }
    for (int j = y.first; j <= y.last; ++j) at(j);
  }
  return balance;
}

OilBalance oil_balance(const core::Patch& grid, const Fields& state, const Transport& transport) {
  const Fluxes fluxes(grid, state, transport);
  const double hx = grid.hx();
  const double hy = grid.hy();
  OilBalance balance;
  for (int j = 1; j <= grid.last_line(); ++j) {
    balance.in += grid.lines(j) * hy * fluxes.along_x(0, j);
    balance.out += grid.lines(j) * hy * fluxes.along_x(grid.nx - 1, j);
  }
  const bool mirrored = grid.north == core::Edge::mirror;
  for (int i = 1; i < grid.nx; ++i)
    balance.aside +=
        hx * ((mirrored ? -2.0 : -1.0) * fluxes.along_y(i, 0) + (mirrored ? 0.0 : fluxes.along_y(i, grid.ny - 1)));
  return balance;
}

}  // namespace ehl::reynolds
