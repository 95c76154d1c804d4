#pragma once
// Distribution of load, pressure and film along a roller.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::roller {

/// Values on a line of constant Y.
struct Slice {
  double Y = 0.0;
  double load = 0.0;  ///< load per length over the mean
  double P_max = 0.0;
  double H_min = 0.0;
  double H_c = 0.0;  ///< at the node next to X = 0
};

/// Extreme values near one end of the roller, in the outer tenth of its length.
struct End {
  double P = 0.0;  ///< highest pressure and its Y
  double P_Y = 0.0;
  double H = 0.0;  ///< least film and its Y
  double H_Y = 0.0;
};

/// Distribution along the whole roller.
struct Distribution {
  std::vector<Slice> slices;  ///< from the lower end (Y < 0) to the upper
  Slice middle;
  End lower, upper;          ///< Y < 0, Y > 0
  double load_centre = 0.0;  ///< Y of the resultant: integral of P Y over that of P
  double P_at_ends = 0.0;    ///< highest pressure on the lines next to the end faces
};

/// True in the outer tenth at either end of a grid that is as wide as the roller is long.
bool near_end(const core::Grid& grid, double Y);

/// in: fields on the whole domain from end to end of the roller; ny even. order: 2 in the mesh size where P is smooth;
/// 1 for the extreme values, which are nodal.
Distribution distribution(const core::Grid& grid, const core::Field& P, const core::Field& H);

}  // namespace ehl::roller
