#pragma once
// Profile of a roller along its axis, as a contribution to the gap. Y in a, gaps in a^2/R.
#include <functional>

#include "core/field.hpp"
#include "core/grid.hpp"

namespace ehl::roller {

/// Treatment of a measured profile and its results. Lengths in a, heights in a^2/R.
struct Trace {
  bool level = false;          ///< subtract the least-squares line
  double shortest_wave = 0.0;  ///< cut-off wavelength of the Gaussian filter; 0: no smoothing
  double slope = 0.0;          ///< dH/dY that was subtracted
  double rough = 0.0;          ///< Rq of the profile in waves up to longest_of_roughness (trace.hpp)
  double rough_before = 0.0;   ///< Rq before smoothing
};

/// Profile of a roller: its shape with the parameters of that shape, and its tilt. Lengths in a, heights in a^2/R.
struct Profile {
  enum class Shape {
    straight,     ///< straight, and at both ends over end_length falling as (Y - Y_s)^2/(2 end_radius)
    crowned,      ///< Y^2/(2 crown_radius)
    logarithmic,  ///< Lundberg's profile with the end correction of Johns and Gohar
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
  double tilt = 0.0;  ///< dH/dY: the gap grows towards y > 0
};

/// Drop of the surface below that of a straight roller, 0 in the middle. logarithmic: under the design load Q every
/// slice of the dry contact has Hertz' pressure, except near the ends:
///   (Q/4) ln 1/[1 - (1 - 0.6066 sqrt(Q)/length) (2 Y/length)^2],
/// in SI 2 F'/(pi E') ln(..). source: Lundberg 1939; Johns and Gohar 1981 (finite drop at the end).
/// limits: |Y| <= length/2.
double drop(const Profile& profile, double Y);

/// Adds drop and tilt to S at all nodes.
void add_gap(const Profile& profile, const core::Patch& grid, core::Field& S);

/// True if drop and tilt are symmetric in Y.
bool symmetric(const Profile& profile);

}  // namespace ehl::roller
