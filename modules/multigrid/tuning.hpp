#pragma once
// The tuned numbers of the multigrid solver (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::multigrid {

// clang-format off: one line per number
struct Tuning {
  // Y sweep (across_relaxation.cpp)
  core::Positive y_sweep_crossover = 0.25;  ///< Y sweep: its crossover over that of the X sweep, per (hx/hy)^2
  core::Share y_sweep_damping = 0.7;        ///< Y sweep: damping
  core::Share y_sweep_damping_steep = 0.5;  ///< Y sweep: further damping where epsilon is steep
  core::Share y_sweep_edge = 1e-4;          ///< Y sweep: e_min/e_max below which epsilon is steep
  core::Positive film_along_edge = 2.0;     ///< film response at an edge on coarse grids, in K(0, 0)

  // X sweep (line_coefficients.cpp, line_batch.cpp)
  core::Share share_of_lines_beside = 0.3;  ///< share of the derivatives of viscosity and epsilon by the lines beside

  // Correcting grids (coarse_problem.cpp, hierarchy.cpp)
  core::Positive elastic_coupling = 0.5;  ///< coupling by the elastic film, in epsilon/h^2
  core::Share coarse_film_floor = 0.9;    ///< least share of the finer film in a coarse epsilon
  core::Count fewest_lines = 8;           ///< least number of lines of a correcting grid

  // Coarsest grid (cycle.cpp)
  core::Count coarsest_sweeps_per_cycle = 30;  ///< least relaxations of the coarsest grid per cycle
  core::Positive coarsest_cells = 32.0;        ///< cells along X that these solve [bench: cells_of_coarsest_sweeps]
  core::Positive coarsest_lines = 16.0;  ///< lines that these solve, stretched cells [bench: lines_of_coarsest_sweeps]
  core::Positive coarsest_raised = 2.0;  ///< growth of the residual in a visit that is repeated
  core::Share largest_fall = 0.5;        ///< largest relative fall of the central film in a visit

  // Damping of the cycles (cycles.cpp)
  core::Share rough_factor = 0.4;          ///< convergence factor above which a cycle is slow
  core::Positive hopeless_residual = 1e3;  ///< relative residual that counts as divergence
  core::Count patience = 6;                ///< cycles in which the residual must fall [bench: cycles_patience]
  core::Share hardly_less = 0.5;           ///< factor by which the residual must fall in them [bench: cycles_patience]
  core::Share poor_factor = 0.75;          ///< convergence factor above which a cycle is poor
  core::Share back_off = 0.8;              ///< factor on weights that are too large: the steep weight first, then all
  core::Share least_steep = 0.6;           ///< lower limit of the steep weight [bench: back_off]
  core::Share least_all = 0.5;             ///< lower limit of all weights [bench: back_off]
  core::Share good_factor = 0.6;  ///< convergence factor that raises the steep weight [bench: steep_weight_growth]
  core::Positive growth_per_cycle = 1.25;  ///< factor on the steep weight by a good cycle [bench: steep_weight_growth]
  core::Positive growth_limit = 1.4;       ///< upper limit of these factors together [bench: steep_weight_growth]
  core::Count krylov_states = 4;           ///< states of the Krylov acceleration

  // Meniscus (cycles.cpp, chattering.cpp, full_multigrid.cpp)
  core::Count meniscus_moves = 15;          ///< first cycles, in which a meniscus may still move
  core::Count changes_of_chattering = 4;    ///< changes of kind after which a node chatters
  core::Positive meniscus_residual = 1e-2;  ///< residual below which a coarse meniscus has its place
  core::Count meniscus_cycles = 4;          ///< most cycles for its place, in extra_cycles [bench: meniscus_residual]
  core::Count cycles_per_supply = 8;        ///< cycles for each supply on the first grid [bench: supply_steps]
  core::Reduction next_supply = 0.7;        ///< next supply over the present one [bench: supply_steps]
  core::Share thinnest_supply = 0.01;       ///< last supply over the flooded film [bench: supply_steps]

  // Global mass correction (mass_balance.cpp)
  core::Positive balanced_oil = 5e-11;   ///< largest mass defect over the flow
  core::Positive inlet_pressure = 0.03;  ///< pressure below which the inlet is corrected
  core::Positive inlet_factor = 1e-6;    ///< first step of the factor on the inlet's pressure

  // Start (start.cpp)
  core::Count sweeps_per_balance = 4;      ///< relaxations per correction of H00 at the start
  core::Count cycles_from_hertz = 4;       ///< first cycles with epsilon as the mean of the nodes
  core::Positive pressure_outside = 0.02;  ///< largest initial pressure outside the contact
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::multigrid
