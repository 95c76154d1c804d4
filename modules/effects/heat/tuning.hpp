#pragma once
// The tuned numbers of the thermal iteration (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::heat {

// clang-format off: one line per number
struct Tuning {
  // Passes (passes.cpp)
  core::Share least_weight = 0.1;  ///< smallest under-relaxation factor
  core::Share half_of_it = 0.5;    ///< share of the expected fall that keeps the under-relaxation [bench: heat_weights]
  core::Reduction less = 0.7;  ///< factor on under-relaxation that falls; grows by the inverse [bench: heat_weights]
  core::Positive unknown_error = 1e-2;  ///< assumed discretization error on a single grid [bench: heat_errors]
  core::Positive least_error = 1e-3;    ///< least error, of the criterion and of error bars [bench: heat_errors]
  core::Positive zero = 1e-6;           ///< friction, and temperature rise over T0, that count as zero
  core::Share enough_of_a_pass = 0.5;   ///< factor on the residual at which a pass ends [bench: heat_cycles_of_a_pass]
  core::Count most_cycles = 8;          ///< most cycles of a pass [bench: heat_cycles_of_a_pass]
  core::Count quick = 3;                ///< first passes, with one sweep of the temperature [bench: heat_slow_sweeps]
  core::Count sweeps_when_slow = 3;     ///< sweeps in the later passes [bench: heat_slow_sweeps]
  core::Positive order = 2.0;           ///< order of friction and temperatures [bench: heat_order_of_two_grids]

  // Sequence of grids (solve.cpp)
  core::Count cells_of_first_line = 64;   ///< most cells of a line contact's first grid [bench: heat_first_line]
  core::Positive change_below = 2e-3;     ///< residual and change on the coarser grids [bench: heat_coarse_tolerance]
  core::Positive change_of_first = 3e-4;  ///< change on the first grid
  core::Share gentle = 0.25;              ///< first under-relaxation factor of a second attempt

  // Error bars (report.cpp, solve.cpp)
  core::Positive order_of_two_grids = 1.0;  ///< order of temperatures with two grids
  core::Positive wider = 1.5;     ///< safety factor on the errors of temperatures [bench: heat_order_of_two_grids]
  core::Positive grows_on = 2.0;  ///< further rise under a spike over its last rise [bench: heat_behind_spike]
  core::Positive share_of_warm_inlet = 0.03;  ///< inlet error per change of ln epsilon
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::heat
