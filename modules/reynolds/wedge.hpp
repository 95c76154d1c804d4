#pragma once
namespace ehl::reynolds {

/// The discrete wedge term d(rho_bar H)/dX at a node, the difference of what its faces carry (flux.hpp):
/// upstream1 (Q_i - Q_{i-1})/hx, upstream2 (1.5 Q_i - 2 Q_{i-1} + 0.5 Q_{i-2})/hx with upstream1 at i = 1.
/// upstream3 is of third order, (2 Q_{i+1} + 3 Q_i - 6 Q_{i-1} + Q_{i-2})/(6 hx), where the pressure couples the nodes,
/// and upstream2 where the film alone does: there it would ripple ahead of the pressure spike. upstream3_inlet is of
/// third order upstream of X = 0, upstream2 behind it.
enum class Wedge { upstream1, upstream2, upstream3, upstream3_inlet };

/// How epsilon gets to the half point between two nodes, and so where it is kept. mean: the arithmetic mean of the
/// nodes, where it is kept. logmean: made there of what the nodes have (film/half_points.hpp) and kept with the node
/// before it, epsilon at (i + 1/2, j) and (i, j + 1/2) with node (i, j). logmean_bounded: likewise, but with no less
/// than a share of the mean fluidity of the two, least_share(), to which it goes over smoothly.
enum class Face { mean, logmean, logmean_bounded };
/// 0.4 is the logarithmic mean over a change of ln eta by 4.9 from one node to the next: such a flank, behind a spike
/// at large L, is not resolved, the little that the logarithmic mean lets through no better than the mean, and no
/// coarse grid can tell it. Of 0, 0.15, 0.25, 0.4 and 0.6 at L = 10 to 25: up to 0.4 the films are the same within
/// 0.003 %, and from there on cycles converge as with the mean.
inline double least_share(Face face) { return face == Face::logmean_bounded ? 0.4 : 0.0; }

/// How the film is carried, U d(rho_bar H)/dX + c rho_bar H: the wedge, and the squeeze of an implicit time step, whose
/// part that is known stands on the right-hand side. Steady: U = 1, c = 0.
struct Transport {
  Transport(Wedge form, double U = 1.0, double c = 0.0) : wedge(form), speed(U), squeeze(c) {}

  Wedge wedge;
  double speed;    ///< U >= 0, entrainment speed over the one that lambda is made with
  double squeeze;  ///< c >= 0 [1/T], T = t u_m/a
  /// epsilon/h^2 over U at which upstream3 is half of third order. Measured from 0.01 to 3 at L = 5 to 20: the error
  /// of Hm is the same from 0.1 to 3, that of Hc on coarse grids less with 0.3, and cycles converge better with 1.
  double third_order_from = 1.0;
};

inline bool third_order(Wedge wedge) { return wedge == Wedge::upstream3 || wedge == Wedge::upstream3_inlet; }

/// Order of the discretization error that the wedge term leaves.
inline double order(Wedge wedge) { return wedge == Wedge::upstream1 ? 1.0 : 2.0; }

}  // namespace ehl::reynolds
