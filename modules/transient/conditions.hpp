#pragma once
// The conditions of a contact that vary in time, and the time steps that resolve them.
#include <array>
#include <optional>
#include <vector>

#include "core/constants.hpp"
#include "surface/relief.hpp"
#include "transient/contact_dae.hpp"
#include "transient/schedule.hpp"
#include "transient/tuning.hpp"

namespace ehl::transient {

/// Oil supplied at the inlet, as a factor on the supply of the scene.
struct Supply {
  Schedule factor{};
  /// Layer on each surface, in units of the scene's supply; at speeds of 1 both together make up that supply. NaN: the
  /// total layer does not depend on the speeds.
  double layer1 = core::unknown, layer2 = core::unknown;
  bool is_flow = false;  ///< factor is a volume flow: at a lower speed the layer is thicker
};

/// What varies in time. T = t u_m/a, u_m the entrainment speed for which lambda of the scene was computed.
struct Conditions {
  Schedule load{};  ///< over the load of the scene
  Schedule u1{};    ///< speed of surface 1 over u_m
  Schedule u2{};
  Schedule radius{};  ///< R_x over that of the scene; R_y stays the same
  std::optional<surface::Relief> on_1{};
  std::optional<surface::Relief> on_2{};
  std::optional<Body> body{};  ///< a body that moves; absent: the film carries the load at all times
  Supply supply{};
  double thinning_k = 0.0;  ///< k of the scene's shear thinning where |u1 - u2| = u_m
  /// Q of cavitated nodes is an unknown even with a flooded inlet. If the scene has a supply, Q always is.
  bool conserves_mass = false;
  Tuning tuning{};
};

/// Load, speeds, supply factor and radius at T.
Drive drive_at(const Conditions& conditions, double T);

/// The moving surfaces, each displaced by the integral of its own speed, and the body. The conditions must outlive the
/// result.
Course course_of(const Conditions& conditions);

/// All schedules, for what is asked of each.
std::array<const Schedule*, 5> schedules_of(const Conditions& conditions);

/// True if no moving surface breaks the symmetry in Y.
bool symmetric(const Conditions& conditions);

/// Times in [0, end] at which a time step must end: jumps, corners, the quarters of short ramps, whole periods, and the
/// end; ascending. in: period, NaN if the conditions do not repeat.
std::vector<double> stops_of(const Conditions& conditions, double end, double period = core::unknown);

/// True if load, speed, radius or supply jumps at T.
bool jumps_at(const Conditions& conditions, double T, double end);

/// Longest time step that resolves everything that varies: a quarter of the time in which a feature moves by its width
/// (for a measured map: by the longer of its own spacing and the mesh size), a quarter of a ramp, a twentieth of a
/// period. With a body also a twentieth of its free vibration and of its time to impact. At most 0.1 and at most
/// end/100.
double longest_step(const Conditions& conditions, double end);

}  // namespace ehl::transient
