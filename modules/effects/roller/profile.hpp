#pragma once
// The shape of a roller along its axis: what the gap gains across the motion. Y in a, gaps in a^2/R.
#include <functional>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::roller {

/// What the deck asks of a traced profile, and what was found of it. Lengths in a, heights in a^2/R.
struct Trace {
  bool level = false;          ///< take the straight line of least squares away
  double shortest_wave = 0.0;  ///< cut-off wavelength of the Gaussian filter; 0: the trace stays as it is
  double slope = 0.0;          ///< dH/dY that was taken away
  double rough = 0.0;          ///< Rq of waves up to longest_of_roughness (trace.hpp) that the profile carries
  double rough_before = 0.0;   ///< the same before smoothing
};

struct Profile {
  enum class Shape {
    straight,     ///< over all but end_length at each end, which fall as (Y - Y_s)^2/(2 end_radius)
    crowned,      ///< Y^2/(2 crown_radius)
    logarithmic,  ///< Lundberg's, with the end of Johns and Gohar
    table
  };
  Shape shape = Shape::logarithmic;
  double length = 0.0;        ///< of the roller
  double end_length = 0.0;    ///< of each rounded end
  double end_radius = 0.0;    ///< over R
  double crown_radius = 0.0;  ///< over R
  double design_load = 1.0;   ///< over the load
  std::function<double(double Y)> table{};
  Trace trace{};      ///< of a table
  double tilt = 0.0;  ///< dH/dY: at Y > 0 the roller stands further off
};

/// How far the surface falls from that of a straight roller, 0 in the middle.
/// logarithmic: under the design load Q the pressure is Hertz' on every slice of the dry contact but near the ends,
///   (Q/4) ln 1/[1 - (1 - 0.6066 sqrt(Q)/length) (2 Y/length)^2],
/// which is 2 F'/(pi E') ln(..) in SI. source: Lundberg 1939; Johns and Gohar 1981, who keep the end finite.
/// limits: |Y| <= length/2.
double drop(const Profile& profile, double Y);

/// Adds drop and tilt at the nodes.
void add_gap(const Profile& profile, const core::Patch& grid, core::Field& S);

/// True where drop and tilt are those of -Y too.
bool symmetric(const Profile& profile);

}  // namespace ehl::roller
