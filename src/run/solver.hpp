#pragma once
// The solver of a kind of contact. The steps from the case to the result are the same for all kinds (pipeline.hpp).
#include <string>

#include "case/effects.hpp"

namespace ehl::program {

struct Solver {
  /// Computes the contact and its main numbers. errors: core::SolverError if there is nothing to show;
  /// core::Interrupted.
  void (*solve)(const Case& input, Progress& progress, Computed& computed) = nullptr;
  std::string (*derived)(const Case& input) = nullptr;  ///< the report of `ehl check`
  std::string (*summary)(const Case& input, const Computed& computed) = nullptr;
  std::string (*json)(const Case& input, const Computed& computed) = nullptr;
  /// What --profile adds: the tuned numbers and the times of the parts; not set: nothing.
  std::string (*profile)(const Case& input, const Computed& computed) = nullptr;
  results::Content (*content)(const Case& input, const Computed& computed) = nullptr;
};

/// The solver of a lubricated contact.
Solver film_solver();
/// The solver of a contact without lubricant.
Solver dry_solver();

}  // namespace ehl::program
