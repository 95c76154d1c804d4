#pragma once
namespace ehl::reynolds {

/// The discrete wedge term d(rho_bar H)/dX at a node, the difference of what its faces carry (flux.hpp):
/// upstream1 (Q_i - Q_{i-1})/hx, upstream2 (1.5 Q_i - 2 Q_{i-1} + 0.5 Q_{i-2})/hx with upstream1 at i = 1.
enum class Wedge { upstream1, upstream2 };

/// How the film is carried, U d(rho_bar H)/dX + c rho_bar H: the wedge, and the squeeze of an implicit time step, whose
/// part that is known stands on the right-hand side. Steady: U = 1, c = 0.
struct Transport {
  Transport(Wedge form, double U = 1.0, double c = 0.0) : wedge(form), speed(U), squeeze(c) {}

  Wedge wedge;
  double speed;    ///< U >= 0, entrainment speed over the one that lambda is made with
  double squeeze;  ///< c >= 0 [1/T], T = t u_m/a
};

/// Order of the discretization error that the wedge term leaves.
inline double order(Wedge wedge) { return wedge == Wedge::upstream2 ? 2.0 : 1.0; }

}  // namespace ehl::reynolds
