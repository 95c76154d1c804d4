#pragma once
// The steady states of a contact under the conditions of single times, for comparison with the run in time.
#include "transient/march.hpp"

namespace ehl::transient {

/// For each time the steady contact under the load, the radius and the speed |U| of that time, as the row of a run in
/// time; its fields are a frame. A state follows from the one before it by increments of load and speed.
///   - U = 0: a steady film has no thickness. The row has NaN and is counted in MarchReport::at_rest.
///   - M(T) < 0.1: the bodies are practically rigid. Hc and Hm are the closed form of the rigid isoviscous film
///     (contact::asymptotes, exact for a line contact), the pressures are NaN.
///   - A state that the cycles do not find, as where the film is too thin for the grid, has NaN and is counted in
///     MarchReport::not_found.
/// in: scene, solution, conditions and observer as for march(), without a body and without reliefs on the surfaces;
/// times, ascending; parameters, of which only `probes` is used. errors: core::SolverError if the first state is not
/// found.
MarchReport quasi_steady(const steady::Scene& scene, const steady::Solution& start, const Conditions& conditions,
                         const MarchParameters& parameters, const std::vector<double>& times, const Observer& observer);

}  // namespace ehl::transient
