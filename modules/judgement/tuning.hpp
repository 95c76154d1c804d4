#pragma once
// The tuned numbers of the stopping criterion and of the error estimates by the grid sequence (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::judgement {

// clang-format off: one line per number
struct Tuning {
  // Stopping criterion (stopping.cpp)
  core::Share algebraic_share = 0.05;            ///< algebraic over discretization error; half of the promised tenth
  core::Positive loose_residual = 4e-3;          ///< relative residual at the discretization error
  core::Positive loose_load_error = 1e-4;        ///< load error at the discretization error [bench: loose_residual]
  core::Share flow_share = 0.25;                 ///< mass imbalance over the discretization error of Hc
  core::Positive least_flow_licence = 1e-4;      ///< mass imbalance that is always allowed [bench: flow_share]
  core::Positive largest_dry_violation = 2e-2;   ///< residual of a cavitated node that calls for pressure
  core::Positive default_tolerance = 1e-6;       ///< residual if the discretization error is unknown
  core::Positive largest_licence = 0.05;         ///< largest discretization error that the checks use
  core::Positive largest_oil_imbalance = 1e-10;  ///< largest net outflow of oil over its inflow
  core::Share best_factor = 0.25;  ///< least convergence factor in the algebraic error [bench: algebraic_factors]
  core::Share worst_factor = 0.9;  ///< largest convergence factor in the algebraic error [bench: algebraic_factors]
  core::Positive settled_change = 1e-3;   ///< change of Hc and Hm at which a first grid has settled
  core::Positive solved_residual = 1e-5;  ///< residual of a state that solves the equations

  // Error estimates (error_estimate.cpp)
  core::Positive safety_of_two = 1.5;             ///< safety factor with two levels [bench: safety]
  core::Positive safety = 1.25;                   ///< safety factor with more levels; also Roache's
  core::Positive cancelled_change = 2.5;          ///< power of 2 by which a change is too small to be believed
  core::Positive first_order_share = 0.35;        ///< error of the first-order wedge over h/Hm^(2/3)
  core::Positive second_order_share = 0.85;       ///< second-order error over its square [bench: error_of_one_grid]
  core::Positive third_order_floor_of_Hc = 0.01;  ///< upstream3: least error of Hc over this [bench: third_order_floor]
  core::Positive third_order_floor_of_Hm = 0.15;  ///< upstream3: least error of Hm over this [bench: third_order_floor]
  core::Share unsure_of_Hc = 0.05;                ///< uncertain share of the extrapolation of Hc [bench: unsure]
  core::Share unsure_of_Hm = 0.2;                 ///< uncertain share of the extrapolation of Hm [bench: unsure]
  core::Share share_of_Hm = 0.2;  ///< share of the error of Hm in that of Hc beside a meniscus [bench: starved_bars]
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::judgement
