#pragma once
// The discrete Reynolds equation (eq. 4), for a double or for a batch of lines at once. Its face flux
//   F = U Q - eps dP/dX   along X,   - eps dP/dY   along Y,   Q = rho_bar H,
// is defined here and nowhere else: the residual, the rows of the relaxation and of Newton's method, the weights of the
// transfers and the balance of mass use it.
#include <algorithm>
#include <array>
#include <limits>

#include "reynolds/wedge.hpp"

namespace ehl::reynolds {

/// Q at the face i+1/2, as the wedge carries it there: upstream1 Q_i; upstream2 1.5 Q_i - 0.5 Q_{i-1}, and
/// (Q_0 + Q_1)/2 at the first face, with which column 1 has upstream1's difference; upstream3 carries that
/// and third_order_part().
/// in: q(k), Q of column k.
template <class Column>
double carried(Wedge wedge, int i, Column q) {
  if (wedge == Wedge::upstream1) return q(i);
  return i == 0 ? 0.5 * (q(0) + q(1)) : 1.5 * q(i) - 0.5 * q(i - 1);
}

/// epsilon at a face, times a factor: the arithmetic mean of the values at the nodes (below eq. 4), or the half-point
/// value that is stored with the node before the face. in: half_factor, half of the factor; 1/(2 h^2) gives the
/// coupling of the nodes.
template <class Number>
Number conductance(Face face, Number before, Number behind, double half_factor) {
  return face == Face::mean ? (before + behind) * half_factor : before * (2.0 * half_factor);
}

/// Coupling of a node through its four faces: epsilon/h^2 there. epsilon along X and along Y may differ.
template <class Number>
struct Faces {
  Number west, east, south, north;
};
template <class Number>
Number total(const Faces<Number>& e) {
  return e.west + e.east + e.south + e.north;
}

/// The factors of conductance() that couple nodes, 1/(2 h^2).
struct HalfInverseSquares {
  explicit HalfInverseSquares(double hx, double hy) : X(0.5 / (hx * hx)), Y(0.5 / (hy * hy)) {}
  double X, Y;
};

/// The faces of node (i, j) from two fields, eps along X and eps_across along Y, which may be the same field.
template <class Field>
Faces<double> faces_at(Face face, const Field& eps, const Field& eps_across, int i, int j,
                       const HalfInverseSquares& half) {
  return {conductance(face, eps(i - 1, j), eps(i, j), half.X), conductance(face, eps(i, j), eps(i + 1, j), half.X),
          conductance(face, eps_across(i, j - 1), eps_across(i, j), half.Y),
          conductance(face, eps_across(i, j), eps_across(i, j + 1), half.Y)};
}

/// Inflow by pressure through the four faces: sum of e (P_neighbour - P_centre).
template <class Number>
Number poiseuille(const Faces<Number>& e, Number west, Number east, Number south, Number north, Number centre) {
  return e.west * (west - centre) + e.east * (east - centre) + e.south * (south - centre) + e.north * (north - centre);
}

/// Weights of Q at i, i-1, i-2 in U dQ/dX + c Q at column i >= 1: the difference of what the faces i+1/2 and i-1/2
/// carry, and the squeeze.
inline std::array<double, 3> transport_weights(const Transport& transport, int i, double hx) {
  const auto weight = [&](int column) {
    const auto one_there = [column](int k) { return k == column ? 1.0 : 0.0; };
    const double net = carried(transport.wedge, i, one_there) - carried(transport.wedge, i - 1, one_there);
    return transport.speed * net / hx;
  };
  return {weight(i) + transport.squeeze, weight(i - 1), weight(i - 2)};
}

/// U dQ/dX + c Q. in: the weights, Q at i, i-1, i-2.
template <class Number>
Number transported(const std::array<double, 3>& c, Number own, Number west, Number far_west) {
  return c[0] * own + c[1] * west + c[2] * far_west;
}

/// Share theta of the third-order flux (2 Q_{i+1} + 5 Q_i - Q_{i-1})/6 at a face of upstream3: theta = e^2/(e^2 + 1),
/// where e is the harmonic mean of epsilon/hx^2 of the two nodes, in units of the value at which theta is a half. The
/// harmonic mean is small if one node has a small epsilon: the pressure there, at the top of a spike, hardly acts
/// through the face.
class ThirdOrderShare {
 public:
  ThirdOrderShare(const Transport& transport, double hx) {
    const double half_at = transport.speed * transport.third_order_from * hx * hx;
    square_ = half_at * half_at;
  }
  double operator()(double before, double behind) const {
    // e = 2 p/q, with one division.
    const double p = before * behind;
    const double q = before + behind;
    constexpr double least = std::numeric_limits<double>::min();  // avoids 0/0
    return 4.0 * p * p / (4.0 * p * p + square_ * q * q + least);
  }
  /// Change of theta with changes of epsilon at the two nodes.
  double change(double before, double behind, double dbefore, double dbehind) const {
    const double q = before + behind;
    if (q <= 0.0) return 0.0;
    const double e = 2.0 * before * behind / q;
    const double de = 2.0 * (behind * behind * dbefore + before * before * dbehind) / (q * q);
    const double sum = e * e + square_;
    return sum > 0.0 ? 2.0 * e * square_ / (sum * sum) * de : 0.0;
  }

 private:
  double square_ = 0.0;  // square of the epsilon at which theta is a half
};
/// theta of upstream3_inlet. in: X of the face.
inline double third_order_in_inlet(double X) {
  constexpr double blend = 0.2;  // width of the transition, in X
  const double s = std::clamp(-X / blend, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}
/// What theta of the third-order flux adds to the flux of upstream2. in: Q at i-1, i, i+1.
template <class Number>
Number third_order_part(Number theta, Number west, Number own, Number east) {
  return theta * (1.0 / 3.0) * (east - 2.0 * own + west);
}

/// theta at the faces west and east of a node.
template <class Number>
struct ThirdOrder {
  Number west, east;
};

/// Weights of Q at i, i-1, i-2, i+1: those of transport_weights() and what third_order_part() adds.
template <class Number>
std::array<Number, 4> third_order_weights(const std::array<double, 3>& c, const Transport& transport, double hx,
                                          const ThirdOrder<Number>& theta) {
  const double factor = transport.speed / (3.0 * hx);
  const Number west = factor * theta.west;
  const Number east = factor * theta.east;
  return {c[0] - 2.0 * east - west, c[1] + east + 2.0 * west, c[2] - west, east};
}
/// U dQ/dX + c Q. in: the weights, Q at i, i-1, i-2, i+1.
template <class Number, class Weight>
Number transported(const std::array<Weight, 4>& c, Number own, Number west, Number far_west, Number east) {
  return c[0] * own + c[1] * west + c[2] * far_west + c[3] * east;
}

/// How many times stronger a change of the film acts in a point's equation than in the steady one, on cells of length
/// hx. The squeeze counts several times (far_part): its kernel is K itself, whose far part a relaxation of single
/// points leaves out, where the wedge has differences of K. [bench: far_part_of_squeeze]
inline double relative_strength(const Transport& transport, double hx) {
  constexpr double far_part = 6.0;
  const double own = carried(transport.wedge, 2, [](int k) { return k == 2 ? 1.0 : 0.0; });
  return transport.speed + far_part * transport.squeeze * hx / own;
}

/// d r/dP of a node, r = U dQ/dX + c Q - poiseuille: derivatives by its own pressure and by those around it.
template <class Number>
struct PressureRow {
  Number far_west, west, own, east, south, north;
};

template <class Number>
PressureRow<Number> sum(const PressureRow<Number>& a, const PressureRow<Number>& b) {
  return {a.far_west + b.far_west, a.west + b.west,   a.own + b.own,
          a.east + b.east,         a.south + b.south, a.north + b.north};
}

/// The row of a wedge of three weights, with epsilon held. in: dQ/dP at i, i-1, i-2.
template <class Number>
PressureRow<Number> pressure_row(const std::array<double, 3>& c, const Faces<Number>& e, Number own, Number west,
                                 Number far_west) {
  return {.far_west = c[2] * far_west,
          .west = c[1] * west - e.west,
          .own = total(e) + c[0] * own,
          .east = -e.east,
          .south = -e.south,
          .north = -e.north};
}

/// The row of upstream3, with epsilon held. in: dQ/dP at i, i-1, i-2, i+1.
template <class Number, class Weight>
PressureRow<Number> pressure_row(const std::array<Weight, 4>& c, const Faces<Number>& e, Number own, Number west,
                                 Number far_west, Number east) {
  return {.far_west = c[2] * far_west,
          .west = c[1] * west - e.west,
          .own = total(e) + c[0] * own,
          .east = c[3] * east - e.east,
          .south = -e.south,
          .north = -e.north};
}

/// Adds to a row that epsilon at the nodes follows the pressures. in: the row with epsilon held; P around node (i, j);
/// d eps/dP along X and along Y.
template <class Field>
PressureRow<double> pressure_row(const PressureRow<double>& held, const Field& P, const Field& slope,
                                 const Field& slope_across, int i, int j, const HalfInverseSquares& half) {
  const Faces<double> steps{half.X * (P(i - 1, j) - P(i, j)), half.X * (P(i + 1, j) - P(i, j)),
                            half.Y * (P(i, j - 1) - P(i, j)), half.Y * (P(i, j + 1) - P(i, j))};
  return {.far_west = held.far_west,
          .west = held.west - steps.west * slope(i - 1, j),
          .own = held.own - (steps.west + steps.east) * slope(i, j) - (steps.south + steps.north) * slope_across(i, j),
          .east = held.east - steps.east * slope(i + 1, j),
          .south = held.south - steps.south * slope_across(i, j - 1),
          .north = held.north - steps.north * slope_across(i, j + 1)};
}

/// Adds to a row that epsilon at half points follows the pressures. in: the row with epsilon held; P around node (i,
/// j); the derivatives of epsilon by the pressures of the nodes before and after the half point, along X and along Y.
template <class Field>
PressureRow<double> pressure_row(const PressureRow<double>& held, const Field& P, const Field& before,
                                 const Field& behind, const Field& before_across, const Field& behind_across, int i,
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

/// poiseuille() of the pressures around node (i, j).
template <class Field>
double poiseuille_at(const Faces<double>& e, const Field& P, int i, int j) {
  return poiseuille(e, P(i - 1, j), P(i + 1, j), P(i, j - 1), P(i, j + 1), P(i, j));
}

}  // namespace ehl::reynolds
