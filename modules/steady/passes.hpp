#pragma once
// One contact after another on the same track: what leaves one is the supply of the next.
#include <functional>
#include <optional>
#include <vector>

#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// What the surfaces bring to the next pass: of `left`, what the last one left behind, and `fresh`, the scene's supply,
/// the shares of scene.passes; then the differences across the track level out by their share. Levelling keeps the oil.
/// in, out: per line of the domain.
std::vector<double> next_layer(const Passes& rule, const std::vector<double>& left, const std::vector<double>& fresh);

/// Finds the solution of a scene from nothing.
using FindSolution = std::function<Solution(const Scene& scene, const ProgressCallback& progress)>;

/// Finds it from the solution of the pass before. out: converged, or one that only swings; else nothing.
using GoOn = std::function<std::optional<Solution>(const Scene& scene, const Solution& before,
                                                   const ProgressCallback& progress)>;
/// That of isothermal contacts, by Newton's method or cycles.
std::optional<Solution> go_on(const Scene& scene, const Solution& before, const ProgressCallback& progress);

/// The supply on Y = 0 of each pass, on a mesh of half as many cells: what the loss of a pass misses for the mesh adds
/// up from pass to pass, and the levels of the last pass do not show it. in: as below; passes >= 1.
/// out: one value per pass, up to the first that this mesh does not solve; none where the cells cannot be halved.
std::vector<double> supplies_on_half_the_cells(const Scene& scene, int passes, const FindSolution& find,
                                               const GoOn& go_on);

/// All passes of a scene with a supply. The first and the last are found from nothing, so that the last has its levels
/// and error bars; those between begin with the state of the one before. Ends with the first that does not converge.
/// in: carried_flooded, rho_bar H C at the centre of the flooded contact.
/// out: the solution of the last pass, with a row for each, in which the error of its supply is; the passes are
/// repeated on half as many cells for that.
Solution solve_passes(const Scene& scene, double carried_flooded, const FindSolution& find, const GoOn& go_on,
                      const ProgressCallback& progress);

}  // namespace ehl::steady
