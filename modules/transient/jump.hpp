#pragma once
// Jumps of load or speed: short backward Euler steps give IDA a consistent state to continue from.
#include <vector>

#include "transient/contact_dae.hpp"

namespace ehl::transient {

/// A backward Euler step, y' = (y - old)/length.
struct EulerStep {
  double T = 0.0;  ///< at its end
  double length = 0.0;
  int cycles = 0;
  int newton_steps = 0;
  std::vector<double> old{};  ///< state at T - length
  std::vector<double> y{};    ///< initial guess, then the state at T
  std::vector<double> yp{};
};

/// The row of a backward Euler step in the report, as for a step of order one by IDA.
inline StepReport report_of(const EulerStep& step) {
  return {.T = step.T, .length = step.length, .order = 1, .cycles = step.cycles, .newton_steps = step.newton_steps};
}

/// Solves the step under the drive at its end, from the guess in y. returns false if the cycles do not converge; y is
/// then still the guess.
bool solve_euler_step(ContactDae& dae, const Drive& drive, EulerStep& step);

/// Drive between two others; share from 0 to 1.
Drive part_of_the_way(const Drive& from, const Drive& to, double share);

/// Solves a step in which the drive changes from one value to another: at once, or by increments that are halved until
/// the cycles converge. returns false if they fail with the smallest increment.
bool solve_step_across(ContactDae& dae, const Drive& from, const Drive& to, EulerStep& step);

}  // namespace ehl::transient
