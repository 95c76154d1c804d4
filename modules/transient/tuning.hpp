#pragma once
// The tuned numbers of the time integration (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::transient {

// clang-format off: one line per number
struct Tuning {
  // Implicit steps (contact_stage.cpp, contact_oil.cpp)
  core::Share best_first_rate = 0.3;  ///< least factor of a first cycle [bench: transient_convergence_factor]
  core::Share best_rate = 0.1;        ///< least factor of later cycles [bench: transient_convergence_factor]
  core::Reduction worst_rate = 0.95;  ///< convergence factor above which a cycle is in vain [bench: transient_patience]
  core::Count patience = 3;           ///< cycles in vain after which the step is cut
  core::Positive strong_squeeze = 1e4;  ///< squeeze from which the load is corrected last only
  core::Count patience_of_newton = 10;  ///< Newton steps in vain after which the step is cut
  core::Count most_by_newton = 32;      ///< most implicit steps by Newton's method in a row
  core::Count edge_reach = 2;  ///< nodes that the edge of the film may move in a step [bench: transient_error_weights]

  // Error test (contact_dae.cpp)
  core::Positive zone_radius = 1.5;      ///< zone of the error norm in Hertz radii [bench: transient_error_weights]
  core::Share weight_outside = 0.1;      ///< weight of nodes outside the zone [bench: transient_error_weights]
  core::Share weight_at_edge = 0.01;     ///< further weight at the edge of the film [bench: transient_error_weights]
  core::Positive least_yielding = 0.05;  ///< least central deformation in the load's correction

  // Time steps (conditions.cpp, march.cpp, jump.cpp)
  core::Positive longest_step = 0.1;      ///< longest step in a/u_m: 20 from -a to a
  core::Share share_of_vibration = 0.05;  ///< longest step over a free vibration [bench: transient_longest_step]
  core::Positive first_step = 1e-3;       ///< first step, and short steps after a jump [bench: transient_first_steps]
  core::Share after_checkpoint = 0.1;  ///< first step after a checkpoint over the last [bench: transient_first_steps]
  core::Count micro_steps = 4;         ///< number of the short steps after a jump
  core::Share least_bit = 1.0 / 64.0;  ///< least part of a jump in one increment [bench: transient_bits]

  // Line contacts (scene_in_time.cpp)
  core::Positive unit_of_line = 4.0;         ///< zero of the line kernel's logarithm in contact sizes
  core::Positive far_squeeze_of_line = 0.2;  ///< film that a relaxation displaces around a node

  // State at the start (settle.cpp)
  core::Positive settled_residual = 1e-9;     ///< relative residual of a steady state [bench: transient_settle]
  core::Positive hopeless_load_error = 0.01;  ///< largest relative error of the load [bench: transient_settle]
  core::Positive bit_of_start = 0.1;          ///< increment of load and speed at the start [bench: transient_bits]
  core::Count cycles_per_bit = 3;             ///< cycles per increment of load and speed
  core::Count most_settling_cycles = 60;      ///< most cycles to the steady state [bench: transient_settle]
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::transient
