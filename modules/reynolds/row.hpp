#pragma once
// The row of one node in the discrete Reynolds equation, and its derivatives:
//   r = U dQ/dX + c Q - sum of e (P_neighbour - P),   U dQ/dX + c Q = sum of w Q over the columns i, i-1, i-2, i+1.
// The residual, the relaxations and Newton's method take their coefficients from here, for a double or for a vector of
// nodes at once. With the mass-conserving cavitation model the march of content.hpp gives w.
#include <algorithm>
#include <array>
#include <cstddef>

#include "reynolds/flux.hpp"
#include "reynolds/residual.hpp"

namespace ehl::reynolds {

/// Values in the columns (constant X) on which a row depends: i, i-1, i-2 and i+1. A row without third-order flux does
/// not read `east`.
template <class Number>
struct Columns {
  Number own, west, far_west, east;
};
/// in: at(k), the value of column k. The first row has no column i-2, and its weight there is 0.
template <class At>
auto columns_at(int i, At at) {
  return Columns<decltype(at(i))>{at(i), at(i - 1), at(std::max(i - 2, 0)), at(i + 1)};
}

/// Weights of Q at i, i-1, i-2.
using WedgeWeights = std::array<double, 3>;

/// The weights in U dQ/dX + c Q at column i >= 1, without third-order flux: the difference of what the faces i+1/2 and
/// i-1/2 carry, and the squeeze. They are the same from column 2 on.
inline WedgeWeights transport_weights(const Transport& transport, int i, double hx) {
  const auto weight = [&](int column) {
    const auto one_there = [column](int k) { return k == column ? 1.0 : 0.0; };
    const double net = carried(transport.wedge, i, one_there) - carried(transport.wedge, i - 1, one_there);
    return transport.speed * net / hx;
  };
  return {weight(i) + transport.squeeze, weight(i - 1), weight(i - 2)};
}

/// Weights of Q at i, i-1, i-2, i+1: those of transport_weights() and what third_order_part() adds. in: theta of the
/// faces.
template <class Number>
std::array<Number, 4> third_order_weights(const WedgeWeights& c, const Transport& transport, double hx,
                                          const ThirdOrder<Number>& theta) {
  const double factor = transport.speed / (3.0 * hx);
  const Number west = factor * theta.west;
  const Number east = factor * theta.east;
  return {c[0] - 2.0 * east - west, c[1] + east + 2.0 * west, c[2] - west, east};
}

/// The weights of a row with or without third-order flux. in: theta(), of the faces; called only if `third`.
template <bool third, class Number, class Theta>
auto wedge_weights(const WedgeWeights& c, const Transport& transport, double hx, Theta theta) {
  if constexpr (third)
    return third_order_weights<Number>(c, transport, hx, theta());
  else
    return c;
}

/// U dQ/dX + c Q.
template <class Number, class Weight, std::size_t columns>
Number transported(const std::array<Weight, columns>& w, const Columns<Number>& Q) {
  const Number upstream = w[0] * Q.own + w[1] * Q.west + w[2] * Q.far_west;
  if constexpr (columns == 3)
    return upstream;
  else
    return upstream + w[3] * Q.east;
}

/// d r/dP of a node: derivatives by its own pressure and by those around it.
template <class Number>
struct PressureRow {
  Number far_west, west, own, east, south, north;
};
/// Adds to a row.
template <class Number>
void add(const PressureRow<Number>& more, PressureRow<Number>& row) {
  row.far_west += more.far_west, row.west += more.west, row.own += more.own;
  row.east += more.east, row.south += more.south, row.north += more.north;
}

// A row consists of the weights of Q, of which there are three without third-order flux, else four, and of the coupling
// through the faces. Both are passed by reference, and results that are stored are written in place: the compiler
// copies structures of wide vectors in halves, for which the next load of a whole vector has to wait.

/// r.
template <class Number, class Weight, std::size_t columns>
Number residual(const std::array<Weight, columns>& w, const Faces<Number>& e, const Columns<Number>& Q,
                const Cross<Number>& P) {
  return transported(w, Q) - poiseuille(e, P);
}
/// d r/dP of the node itself with epsilon held. in: dQ/dP.
template <class Number, class Weight, std::size_t columns>
Number diagonal(const std::array<Weight, columns>& w, const Faces<Number>& e, Number dQ) {
  return total(e) + w[0] * dQ;
}
/// d r/dP with epsilon and H held. in: dQ/dP.
template <class Number, class Weight, std::size_t columns>
PressureRow<Number> by_pressure(const std::array<Weight, columns>& w, const Faces<Number>& e,
                                const Columns<Number>& dQ) {
  Number east = -e.east;
  if constexpr (columns == 4) east = w[3] * dQ.east - e.east;
  return {.far_west = w[2] * dQ.far_west,
          .west = w[1] * dQ.west - e.west,
          .own = diagonal(w, e, dQ.own),
          .east = east,
          .south = -e.south,
          .north = -e.north};
}
/// d r/dH of the columns with epsilon held.
template <class Number, class Weight, std::size_t columns>
void by_film(const std::array<Weight, columns>& w, const Columns<Number>& rho_bar,
             std::array<Number, columns>& slopes) {
  slopes[0] = w[0] * rho_bar.own;
  slopes[1] = w[1] * rho_bar.west;
  slopes[2] = w[2] * rho_bar.far_west;
  if constexpr (columns == 4) slopes[3] = w[3] * rho_bar.east;
}

/// Adds to a row that epsilon at the nodes follows the pressures. in: the row with epsilon held; P around node (i, j);
/// d eps/dP along X and along Y.
inline PressureRow<double> follow_epsilon(const PressureRow<double>& held, const core::Field& P,
                                          const core::Field& slope, const core::Field& slope_across, int i, int j,
                                          const HalfInverseSquares& half) {
  const Faces<double> steps{half.X * (P(i - 1, j) - P(i, j)), half.X * (P(i + 1, j) - P(i, j)),
                            half.Y * (P(i, j - 1) - P(i, j)), half.Y * (P(i, j + 1) - P(i, j))};
  return {.far_west = held.far_west,
          .west = held.west - steps.west * slope(i - 1, j),
          .own = held.own - (steps.west + steps.east) * slope(i, j) - (steps.south + steps.north) * slope_across(i, j),
          .east = held.east - steps.east * slope(i + 1, j),
          .south = held.south - steps.south * slope_across(i, j - 1),
          .north = held.north - steps.north * slope_across(i, j + 1)};
}
/// Adds to a row that epsilon at half points follows the pressures. in: as above, but the derivatives of epsilon by the
/// pressures of the nodes before and after the half point, along X and along Y.
inline PressureRow<double> follow_epsilon(const PressureRow<double>& held, const core::Field& P,
                                          const core::Field& before, const core::Field& behind,
                                          const core::Field& before_across, const core::Field& behind_across, int i,
                                          int j, const HalfInverseSquares& half) {
  const double west = 2.0 * half.X * (P(i - 1, j) - P(i, j));
  const double east = 2.0 * half.X * (P(i + 1, j) - P(i, j));
  const double south = 2.0 * half.Y * (P(i, j - 1) - P(i, j));
  const double north = 2.0 * half.Y * (P(i, j + 1) - P(i, j));
  return {.far_west = held.far_west,
          .west = held.west - west * before(i - 1, j),
          .own = held.own - west * behind(i - 1, j) - east * before(i, j) - south * behind_across(i, j - 1) -
                 north * before_across(i, j),
          .east = held.east - east * behind(i, j),
          .south = held.south - south * before_across(i, j - 1),
          .north = held.north - north * behind_across(i, j)};
}

/// The rows of a grid, node by node.
class NodeRows {
 public:
  /// in: the fields, which must outlive this.
  NodeRows(const core::Patch& grid, const Fields& state, const Transport& transport)
      : state_(state),
        transport_(transport),
        hx_(grid.hx()),
        half_(grid),
        first_(transport_weights(transport, 1, hx_)),
        inner_(transport_weights(transport, 2, hx_)) {}

  const WedgeWeights& wedge(int i) const { return i == 1 ? first_ : inner_; }
  /// theta of the faces of a node; 0 without third-order flux.
  ThirdOrder<double> theta(int i, int j) const {
    if (!third_order(transport_.wedge)) return {};
    return {state_.third_order(i - 1, j), state_.third_order(i, j)};
  }
  /// rho_bar H in the columns of a row.
  Columns<double> Q(int i, int j) const {
    return columns_at(i, [&](int k) { return state_.rho_bar(k, j) * state_.H(k, j); });
  }
  Faces<double> faces(int i, int j) const { return faces_at(state_.face, state_.eps, state_.eps_across, i, j, half_); }
  std::array<double, 4> weights(int i, int j) const {
    return third_order_weights(wedge(i), transport_, hx_, theta(i, j));
  }
  const HalfInverseSquares& half() const { return half_; }

 private:
  Fields state_;
  Transport transport_;
  double hx_;
  HalfInverseSquares half_;
  WedgeWeights first_, inner_;
};

}  // namespace ehl::reynolds
