#pragma once
// The film that is solved together with heat or with flow thinning, and its friction.
#include <optional>

#include "case/computed.hpp"
#include "case/scene.hpp"
#include "steady/solve.hpp"

namespace ehl::program {

/// out: film; what belongs to it, or nothing if there is no isothermal film to begin with. errors: as of
/// heat::solve_coupled().
std::optional<HeatResult> solve_coupled(const Case& input, const thermal::Setup& setup,
                                        const steady::ProgressCallback& progress, steady::Solution& film);

}  // namespace ehl::program
