#pragma once
// Surfaces that touch (mixed lubrication).
#include <limits>

namespace ehl::multigrid {

/// A boundary film of thickness H_b remains between surfaces that touch: H >= H_b, P_c >= 0, P_c (H - H_b) = 0, P_c the
/// pressure between the surfaces. Where P_c reaches the hardness, a surface yields by as much as keeps H at H_b.
struct BoundaryFilm {
  double H_b = 0.0;
  double hardness = std::numeric_limits<double>::infinity();  ///< largest P_c, in p_h
};

}  // namespace ehl::multigrid
