#pragma once
// What varies in time about a contact, and what follows from it for the steps.
#include <limits>
#include <optional>
#include <vector>

#include "surface/relief.hpp"
#include "transient/contact_dae.hpp"
#include "transient/schedule.hpp"

namespace ehl::transient {

/// What is brought to the inlet, over what the scene's supply says.
struct Supply {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Schedule factor{};
  /// Of each surface, in units of the scene's supply, which they make together at speeds of 1; none: a layer that is
  /// the same at all speeds.
  double layer1 = none, layer2 = none;
  bool is_flow = false;  ///< oil per time, which a slower motion brings as a thicker layer
};

/// What varies. Time T = t u_m/a, u_m the entrainment speed that lambda of the scene is made with.
struct Conditions {
  Schedule load{};  ///< over the scene's
  Schedule u1{};    ///< of surface 1 over u_m
  Schedule u2{};
  std::optional<surface::Relief> on_1{};
  std::optional<surface::Relief> on_2{};
  std::optional<Body> body{};  ///< moves; absent: the load is imposed
  Supply supply{};
  /// The oil of dry points is an unknown, though the inlet is full; where the scene has a supply it always is.
  bool conserves_mass = false;
};

/// Load, entrainment speed and supply at T.
Drive drive_at(const Conditions& conditions, double T);

/// The course of the contact: the surfaces, each moved by the integral of its own speed; the body. The conditions must
/// outlive it.
Course course_of(const Conditions& conditions);

/// True where no surface disturbs the symmetry in Y.
bool symmetric(const Conditions& conditions);

/// Times in [0, end] at which a step must end: jumps and corners of what varies, quarters of short
/// ramps, and the end; rising.
std::vector<double> stops_of(const Conditions& conditions, double end);

/// True where load, speed or supply jump at T.
bool jumps_at(const Conditions& conditions, double T, double end);

/// Longest step that sees everything that varies: a quarter of a feature's width at its speed, of a map the longer of
/// its own step and the mesh's, a quarter of a ramp, a twentieth of a period, that of a body's free vibration and the
/// time to its impact too; a tenth of a feature-free time of 10.
double longest_step(const Conditions& conditions, double end);

}  // namespace ehl::transient
