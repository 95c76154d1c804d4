#pragma once
// The steady film of a lubricated contact, with heat where the case has it: what a run and a sweep solve alike.
#include <optional>

#include "case/computed.hpp"
#include "case/scene.hpp"
#include "steady/solve.hpp"

namespace ehl::program {

struct FilmSolution {
  steady::Solution film{};
  std::optional<HeatResult> heat{};
  std::optional<HeatResult> flow{};  ///< as in Computed
};

/// errors: core::SolverError where there is nothing that could be shown; core::Interrupted.
FilmSolution solve_film(const Case& input, const steady::ProgressCallback& progress);

}  // namespace ehl::program
