#pragma once
namespace ehl::reynolds {

/// The discrete wedge term d(rho_bar H)/dX at a node, the difference of what its faces carry (flux.hpp):
/// - upstream1: (Q_i - Q_{i-1})/hx;
/// - upstream2: (1.5 Q_i - 2 Q_{i-1} + 0.5 Q_{i-2})/hx, and upstream1 at i = 1;
/// - upstream3: third order, (2 Q_{i+1} + 3 Q_i - 6 Q_{i-1} + Q_{i-2})/(6 hx), where the pressure couples the nodes,
///   and upstream2 where only the film does, since third order would give ripples ahead of the pressure spike there;
/// - upstream3_inlet: third order upstream of X = 0, upstream2 downstream of it.
enum class Wedge { upstream1, upstream2, upstream3, upstream3_inlet };

/// epsilon at the half point between two nodes, and where it is stored:
/// - mean: the arithmetic mean of the nodes; stored at the nodes;
/// - logmean: computed at the half point (film/half_points.hpp) and stored with the node before it, epsilon at (i +
///   1/2, j) and at (i, j + 1/2) with node (i, j);
/// - logmean_bounded: the same, but with a fluidity of at least the share least_share() of the nodes' mean, to which it
///   goes over smoothly.
enum class Face { mean, logmean, logmean_bounded };
/// Least share of the mean fluidity at a half point. The logarithmic mean reaches this share where ln eta changes by
/// 4.9 between two nodes. Such a flank, behind a spike at large L, is not resolved; what the logarithmic mean lets
/// through there is no better than the bound, and coarse grids cannot represent it. [bench: least_share]
inline double least_share(Face face) { return face == Face::logmean_bounded ? 0.4 : 0.0; }

/// The transport term U d(rho_bar H)/dX + c rho_bar H: the wedge, and the squeeze of an implicit time step, whose known
/// part is on the right-hand side. Steady: U = 1, c = 0.
struct Transport {
  Transport(Wedge form, double U = 1.0, double c = 0.0) : wedge(form), speed(U), squeeze(c) {}

  Wedge wedge;
  double speed;    ///< U >= 0, entrainment speed over the one in lambda
  double squeeze;  ///< c >= 0 [1/T], T = t u_m/a
  /// epsilon/h^2 over U at which upstream3 is half of third order. [bench: third_order_from]
  double third_order_from = 1.0;
};

inline bool third_order(Wedge wedge) { return wedge == Wedge::upstream3 || wedge == Wedge::upstream3_inlet; }

/// Order of the discretization error of the wedge term.
inline double order(Wedge wedge) { return wedge == Wedge::upstream1 ? 1.0 : 2.0; }

}  // namespace ehl::reynolds
