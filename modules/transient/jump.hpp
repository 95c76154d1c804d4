#pragma once
// Across a jump of load or speed: short steps by backward Euler, before IDA goes on from a consistent state.
#include <vector>

#include "transient/contact_dae.hpp"

namespace ehl::transient {

/// A step by backward Euler, y' = (y - old)/length.
struct EulerStep {
  double T = 0.0;  ///< at its end
  double length = 0.0;
  int cycles = 0;
  int newton_steps = 0;
  std::vector<double> old{};  ///< state at T - length
  std::vector<double> y{};    ///< state at T; before it is solved, a guess
  std::vector<double> yp{};
};

inline StepReport report_of(const EulerStep& step) {
  return {.T = step.T, .length = step.length, .order = 1, .cycles = step.cycles, .newton_steps = step.newton_steps};
}

/// Solves the step under the drive at its end, the guess by the state before it. false where the cycles do not
/// converge: y is still the guess.
bool solve_euler_step(ContactDae& dae, const Drive& drive, EulerStep& step);

/// Parts, small enough for the cycles, of the way from one drive to another.
int bits_between(const Drive& from, const Drive& to);

/// A drive on the way; share from 0 to 1.
Drive part_of_the_way(const Drive& from, const Drive& to, double share);

/// Solves the step in which the drive goes from one to the other: bit by bit, in halves where the cycles do not follow.
/// false where the cycles do not converge with the smallest bits.
bool solve_step_across(ContactDae& dae, const Drive& from, const Drive& to, EulerStep& step);

}  // namespace ehl::transient
