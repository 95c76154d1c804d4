#pragma once
// Several contacts on the same track: the layer that one leaves behind is the supply of the next.
#include <functional>
#include <optional>
#include <vector>

#include "steady/scene.hpp"
#include "steady/solution.hpp"
#include "steady/solve.hpp"

namespace ehl::steady {

/// The layer that the surfaces bring to the next pass: the shares of scene.passes of `left`, which the last pass left
/// behind, and of `fresh`, the scene's supply; then the differences across the track level out by their share, which
/// conserves the oil. in, out: one value per line of the domain.
std::vector<double> next_layer(const Passes& rule, const std::vector<double>& left, const std::vector<double>& fresh);

/// Finds the solution of a scene without a previous one.
using FindSolution = std::function<Solution(const Scene& scene, const ProgressCallback& progress)>;

/// Finds the solution from that of the previous pass. out: a converged solution, or one in which only nodes at the edge
/// of the film chatter; else nothing.
using GoOn = std::function<std::optional<Solution>(const Scene& scene, const Solution& before,
                                                   const ProgressCallback& progress)>;
/// GoOn of isothermal contacts: by Newton's method or cycles.
std::optional<Solution> go_on(const Scene& scene, const Solution& before, const ProgressCallback& progress);

/// The supply on Y = 0 of each pass on half as many cells. The mesh error of a pass's loss adds up from pass to pass,
/// which the levels of the last pass do not show. in: as below; passes >= 1.
/// out: one value per pass, up to the first that this mesh does not solve; none if the cells cannot be halved.
std::vector<double> supplies_on_half_the_cells(const Scene& scene, int passes, const FindSolution& find,
                                               const GoOn& go_on);

/// Solves all passes of a scene with a supply. The first and the last start without a previous solution, so that the
/// last has levels and error bars; the others start from the previous pass. Stops at the first pass that does not
/// converge. The passes are repeated on half as many cells for the error of the supply.
/// in: carried_flooded, rho_bar H C at the centre of the flooded contact.
/// out: the solution of the last pass, with a row for each pass that includes the error of its supply.
Solution solve_passes(const Scene& scene, double carried_flooded, const FindSolution& find, const GoOn& go_on,
                      const ProgressCallback& progress);

}  // namespace ehl::steady
