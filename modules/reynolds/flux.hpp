#pragma once
// The discrete Reynolds equation (eq. 4), for a double or for a batch of lines at once. Its face flux
//   F = U Q - eps dP/dX   along X,   - eps dP/dY   along Y,   Q = rho_bar H,
// is defined here and nowhere else: the rows (row.hpp), the weights of the transfers and the balance of mass use it.
#include <algorithm>
#include <limits>

#include "core/grid.hpp"
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

/// The factors of conductance() that couple nodes, 1/(2 h^2). Y = 0 in a line contact, whose cells have no end along Y.
struct HalfInverseSquares {
  explicit HalfInverseSquares(const core::Patch& grid)
      : X(0.5 / (grid.hx() * grid.hx())), Y(0.5 / (grid.domain.between_lines() * grid.domain.between_lines())) {}
  double X, Y;
};

/// True if oil flows along Y.
inline bool flows_aside(const core::Patch& grid) { return HalfInverseSquares(grid).Y > 0.0; }

/// A node and its four neighbours.
template <class Number>
struct Cross {
  Number west, east, south, north, own;
};
template <class Field>
Cross<double> cross_at(const Field& f, int i, int j) {
  return {f(i - 1, j), f(i + 1, j), f(i, j - 1), f(i, j + 1), f(i, j)};
}

/// The faces of a node. in: epsilon of the node and its neighbours, `own` of eps along X; own_across, epsilon of the
/// node along Y.
template <class Number>
Faces<Number> faces(Face face, const Cross<Number>& eps, Number own_across, const HalfInverseSquares& half) {
  return {conductance(face, eps.west, eps.own, half.X), conductance(face, eps.own, eps.east, half.X),
          conductance(face, eps.south, own_across, half.Y), conductance(face, own_across, eps.north, half.Y)};
}
/// The faces of node (i, j) from two fields, eps along X and eps_across along Y, which may be the same field.
template <class Field>
Faces<double> faces_at(Face face, const Field& eps, const Field& eps_across, int i, int j,
                       const HalfInverseSquares& half) {
  return faces<double>(face, {eps(i - 1, j), eps(i + 1, j), eps_across(i, j - 1), eps_across(i, j + 1), eps(i, j)},
                       eps_across(i, j), half);
}

/// Inflow by pressure through the four faces: sum of e (P_neighbour - P).
template <class Number>
Number poiseuille(const Faces<Number>& e, const Cross<Number>& P) {
  return e.west * (P.west - P.own) + e.east * (P.east - P.own) + e.south * (P.south - P.own) +
         e.north * (P.north - P.own);
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

/// How many times stronger a change of the film acts in a point's equation than in the steady one, on cells of length
/// hx. The squeeze counts several times (far_part): its kernel is K itself, whose far part a relaxation of single
/// points leaves out, where the wedge has differences of K. [bench: far_part_of_squeeze]
inline double relative_strength(const Transport& transport, double hx) {
  constexpr double far_part = 6.0;
  const double own = carried(transport.wedge, 2, [](int k) { return k == 2 ? 1.0 : 0.0; });
  return transport.speed + far_part * transport.squeeze * hx / own;
}

}  // namespace ehl::reynolds
