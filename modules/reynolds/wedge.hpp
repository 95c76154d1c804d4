#pragma once
namespace ehl::reynolds {

/// The discrete wedge term d(rho_bar H)/dX at a node:
/// upstream1 (r_i - r_{i-1})/hx, upstream2 (1.5 r_i - 2 r_{i-1} + 0.5 r_{i-2})/hx with upstream1 at i = 1.
enum class Wedge { upstream1, upstream2 };

/// Order of the discretization error that the wedge term leaves.
inline double order(Wedge wedge) { return wedge == Wedge::upstream2 ? 2.0 : 1.0; }

}  // namespace ehl::reynolds
