#pragma once
// What a user must know about a solution that the checks let pass.
#include <string>
#include <vector>

#include "steady/scene.hpp"
#include "steady/solution.hpp"

namespace ehl::steady {

/// A film with a larger estimated error counts as not resolved.
inline constexpr double unresolved_film = 0.1;

/// Cells along x that would bring an estimated error down to unresolved_film: `cells` doubled as often as the order of
/// the wedge asks for, never less than once for an error above it. The scheme's order and not the observed one, which
/// on a grid too coarse to hold the film says little.
/// in: cells of the grid, relative error there. limits: an error above 100 % is no number to count with; it is taken as
/// 100 %, and the cells are the fewest that may do.
int cells_that_resolve(int cells, double error, reynolds::Wedge wedge);

/// What helps a roller whose film is negative at one of its ends: there its edge cuts through the film, on every mesh.
/// out: empty where that is not so.
std::string advice_for_cutting_ends(const Scene& scene, const Solution& solution);

/// Warnings with numbers: film not resolved by the mesh (estimated error above 10 %, with the cells that would do; no
/// estimate possible from a single level; a film that is negative between the nodes), inlet starved by the domain,
/// outlet boundary inside the pressure region, pressure still carried at the sides. in: a solution of the scene whose
/// levels, P and grid are complete.
std::vector<std::string> warnings_of(const Scene& scene, const Solution& solution);

}  // namespace ehl::steady
