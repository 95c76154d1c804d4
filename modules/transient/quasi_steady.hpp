#pragma once
// The steady states of a contact under the conditions of single times, for comparison with the run in time.
#include "transient/march.hpp"

namespace ehl::transient {

/// The dry contact under another load and radius R_x, both over those before; R_y stays the same.
struct DryContact {
  contact::Ellipse shape;
  double length;    ///< a over that before
  double pressure;  ///< p_h likewise
};
DryContact dry_contact(const contact::Ellipse& before, double load, double radius);

/// The steady contact under the load, the radius and the speed |U| at T, and the factors that turn its units into those
/// of the given scene. The grid has the same nodes.
struct StateScene {
  steady::Scene scene;
  double length = 1.0;    ///< a over that of the given scene
  double film = 1.0;      ///< a^2/R likewise
  double pressure = 1.0;  ///< p_h likewise
};
/// in: conditions with U(T) != 0.
StateScene scene_at(const steady::Scene& scene, const Conditions& conditions, double T);

/// The steady solution at T, in the units of the given scene; nullopt if it is not found, or if the scene has surfaces
/// or coatings, whose sizes scene_at() does not convert. in: conditions with U(T) > 0.
std::optional<Frame> steady_frame(const steady::Scene& scene, const Conditions& conditions, double T);

/// For each time the steady contact under the load, the radius and the speed |U| of that time, as the row of a run in
/// time; its fields are a frame. Each is solved by itself, by the steady solver.
///   - U = 0: a steady film has no thickness. The row has NaN and is counted in MarchReport::at_rest.
///   - M(T) < 0.1: the bodies are practically rigid. Hc and Hm are the closed form of the rigid isoviscous film
///     (contact::asymptotes, exact for a line contact), the pressures are NaN.
///   - A state that does not converge, as where the film is too thin for the grid, has NaN and is counted in
///     MarchReport::not_found; MarchReport::reason is that of the first one.
/// `going_on` is called while a state is being solved and returns whether to continue; if not, the state under way has
/// NaN but does not count as not found, and the report ends as interrupted.
/// in: scene and conditions as for march(), without a body and without reliefs on the surfaces; times, ascending;
/// parameters, of which only `probes` is used. Effects at steps are not evaluated.
MarchReport quasi_steady(const steady::Scene& scene, const Conditions& conditions, const MarchParameters& parameters,
                         const std::vector<double>& times, const Observer& observer,
                         const std::function<bool()>& going_on = {});

}  // namespace ehl::transient
