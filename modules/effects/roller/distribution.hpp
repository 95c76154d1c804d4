#pragma once
// How load, pressure and film are distributed along a roller.
#include <vector>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::roller {

/// A line of constant Y.
struct Slice {
  double Y = 0.0;
  double load = 0.0;  ///< per length, over the mean
  double P_max = 0.0;
  double H_min = 0.0;
  double H_c = 0.0;  ///< at X = 0, or the node next to it
};

/// What happens near an end: the outer tenth of the length.
struct End {
  double P = 0.0;  ///< highest pressure, and where
  double P_Y = 0.0;
  double H = 0.0;  ///< least film, and where
  double H_Y = 0.0;
};

struct Distribution {
  std::vector<Slice> slices;  ///< from the lower end to the upper
  Slice middle;
  End lower, upper;          ///< Y < 0, Y > 0
  double load_centre = 0.0;  ///< Y of the resultant: the integral of P Y over that of P
  double P_at_ends = 0.0;    ///< highest pressure beside the end faces
};

/// The outer tenth of a grid that is as wide as the roller is long.
bool near_end(const core::Grid& grid, double Y);

/// in: fields on all of a domain from one end of the roller to the other, ny even. order: 2 in the mesh size where P
/// is smooth, 1 for the highest values, which are those of nodes.
Distribution distribution(const core::Grid& grid, const core::Field& P, const core::Field& H);

}  // namespace ehl::roller
