#pragma once
// Warnings about a solution that the checks accept.
#include <string>

#include "core/warning.hpp"
#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

/// Estimated error above which a film counts as not resolved.
inline constexpr double unresolved_film = 0.1;

/// Number of cells along x that would bring an estimated error down to unresolved_film: `cells` doubled as often as the
/// order of the wedge requires, at least once for an error above it. The theoretical order is used, because the
/// observed one means little on a grid too coarse to resolve the film.
/// in: cells of the grid, relative error there. limits: an error above 100 % is taken as 100 %; the result is then the
/// least number that may suffice.
int cells_that_resolve(int cells, double error, reynolds::Wedge wedge);

/// Advice for a roller whose edge cuts through the film at one end, which gives a negative film on every mesh. out:
/// empty if that is not so.
std::string advice_for_cutting_ends(const Scene& scene, const Solution& solution);

/// Warnings, with numbers: a film not resolved by the mesh (estimated error above 10 %, with the cells that would
/// suffice; no estimate from a single level; a film that is negative between the nodes), an inlet starved by the
/// domain, an outlet boundary inside the pressure region, pressure at the sides. in: a solution of the scene whose
/// levels, P and grid are complete.
core::Warnings warnings_of(const Scene& scene, const Solution& solution);

}  // namespace ehl::steady
