#pragma once
// What is solved. The way from the deck to the result is the same for all (command_run.cpp).
#include <string>

#include "case/effects.hpp"

namespace ehl::program {

struct Solver {
  /// Fills all of the solution but what the effects add to it. errors: core::SolverError where there is nothing that
  /// could be shown; core::Interrupted.
  void (*solve)(const Case& input, Progress& progress, Computed& computed) = nullptr;
  std::string (*derived)(const Case& input) = nullptr;  ///< what `ehl check` says
  std::string (*summary)(const Case& input, const Computed& computed) = nullptr;
  std::string (*json)(const Case& input, const Computed& computed) = nullptr;
  results::Content (*content)(const Case& input, const Computed& computed) = nullptr;
};

/// The film of a lubricated contact.
Solver film_solver();
/// The contact without lubricant.
Solver dry_solver();

}  // namespace ehl::program
