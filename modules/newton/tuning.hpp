#pragma once
// The tuned numbers of Newton's method (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::newton {

// clang-format off: one line per number
struct Tuning {
  core::Positive longest_change = 0.3;  ///< largest change of a pressure in one step, in p_h [bench: longest_change]
  core::Positive small_change = 0.02;   ///< change of a step below which the iteration converges
  core::Share loose = 1e-2;             ///< largest tolerance of a linear system [bench: newton_linear_tolerance]
  core::Share tight = 1e-5;             ///< least tolerance of a linear system [bench: newton_linear_tolerance]
  core::Share last_bit = 0.03;          ///< last linear tolerance over what is needed [bench: newton_linear_tolerance]
  core::Count patience = 20;            ///< steps without a better state until it fails
  core::Count patience_at_the_end = 5;  ///< steps without a better state near the solution [bench: newton_patience]
  core::Positive near = 1e-6;           ///< residual that counts as near the solution [bench: newton_patience]
  core::Share step_tolerance = 1e-3;    ///< tolerance of the linear systems in time
  core::Count step_worn_out = 8;        ///< iterations at which factors are replaced in time [bench: worn_out_factors]
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::newton
