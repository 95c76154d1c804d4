#pragma once
namespace ehl::reynolds {

/// The discrete wedge term d(rho_bar H)/dX at a node:
/// upstream1 (r_i - r_{i-1})/hx, upstream2 (1.5 r_i - 2 r_{i-1} + 0.5 r_{i-2})/hx with upstream1 at i = 1.
enum class Wedge { upstream1, upstream2 };

/// How the film is carried, U d(rho_bar H)/dX + c rho_bar H: the wedge, and the squeeze of an implicit time step, whose
/// part that is known stands on the right-hand side. Steady: U = 1, c = 0.
struct Transport {
  Transport(Wedge form, double U = 1.0, double c = 0.0) : wedge(form), speed(U), squeeze(c) {}

  /// How many times stronger the film's own change acts in a point's equation than in the steady one, on cells hx long.
  /// The squeeze counts several times: its kernel is K itself, whose far part a relaxation of single points leaves out,
  /// where the wedge has differences of K. Measured from c = 10 to 10^4 on 65^2 and 257^2 nodes: with a factor of 1 the
  /// cycles diverge from c = 3000 on, with 4 to 10 they leave 0.1 to 0.2 of the error everywhere.
  double strength(double hx) const {
    constexpr double far_part = 6.0;
    return speed + far_part * squeeze * hx / (wedge == Wedge::upstream2 ? 1.5 : 1.0);
  }

  Wedge wedge;
  double speed;    ///< U >= 0, entrainment speed over the one that lambda is made with
  double squeeze;  ///< c >= 0 [1/T], T = t u_m/a
};

/// Order of the discretization error that the wedge term leaves.
inline double order(Wedge wedge) { return wedge == Wedge::upstream2 ? 2.0 : 1.0; }

}  // namespace ehl::reynolds
