#pragma once
// Solves the steady film of a lubricated contact, with heat if the case has it, for runs and sweeps.
#include <optional>

#include "case/computed.hpp"
#include "case/scene.hpp"
#include "steady/solve.hpp"

namespace ehl::program {

struct FilmSolution {
  steady::Solution film{};
  std::optional<HeatResult> heat{};
  std::optional<HeatResult> flow{};  ///< the same as in Computed
};

/// errors: core::SolverError if there is nothing to show; core::Interrupted.
FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress);

}  // namespace ehl::program
