#pragma once
// The tuned numbers of the steady solver (core/tuning.hpp).
#include "core/tuning.hpp"

namespace ehl::steady {

// clang-format off: one line per number
struct Tuning {
  // Cycles and weights (cycle_choice.cpp)
  core::Positive steep_log_viscosity = 20.0;  ///< ln eta_bar near the edge above which the steep weight is damped
  core::Share damping_where_steep =
      0.8;  ///< factor on the steep weight where it is damped [bench: steep_log_viscosity]
  core::Positive steep_log_viscosity_of_slender = 9.0;  ///< ln eta_bar from which stretched cells relax (3,2)
  core::Count settling_sweeps = 4;            ///< relaxations after an interpolation, with more relaxations per cycle
  core::Share settling_weight = 0.4;          ///< factor on the weights of these relaxations [bench: settling_sweeps]
  core::Positive widest_coarsest_step = 2.5;  ///< coarsest cell over the shorter half of an oblique contact
  core::Positive widest_coarsest_step_elongated =
      0.8;  ///< coarsest cell if it is elongated [bench: widest_coarsest_step]
  core::Positive widest_coarsest_step_of_heavy_line = 0.15;  ///< coarsest cell of heavily loaded lines
  core::Positive crossover_of_line = 3e3;              ///< epsilon/h^2 above which a point of a line is relaxed singly
  core::Positive least_single_epsilon_of_line = 0.02;  ///< epsilon above which a point of a line is relaxed singly
  core::Share weight_of_line = 0.8;                    ///< under-relaxation of distributed changes on lines
  core::Share weight_when_stretched = 0.8;             ///< factor on all weights on stretched cells
  core::Share steep_when_stretched = 0.6;              ///< further factor on the steep weight on stretched cells
  core::Positive most_change_of_log_viscosity = 6.0;   ///< step limit: largest change of ln eta in one relaxation
  core::Share coarse_before_across = 0.6;   ///< factor on X sweeps of coarse oblique grids if a Y sweep follows
  core::Positive film_zones_of_line = 8.0;  ///< zone of Gauss-Seidel changes of a line, in film zones
  core::Share share_of_film_slope = 0.75;   ///< share of the film in the change of H00 with the load

  // Starts (starts.cpp, multigrid_solve.cpp)
  core::Positive steep_log_viscosity_of_line = 18.0;  ///< ln eta_bar of a heavy line [bench: starts_of_heavy_lines]
  core::Positive largest_first_step = 0.4;            ///< largest cell of the first grid over the size of the contact
  core::Positive widest_step = 2.5;                   ///< largest cell of the first grid over the film zone
  core::Share first_film_of_slender = 0.1;  ///< first film over the expected one [bench: first_H00_of_slender_contacts]

  // Load continuation (continuation.cpp)
  core::Positive continuation_tolerance = 1e-4;  ///< residual and load error of an intermediate load
  core::Count continuation_most_cycles = 25;     ///< most cycles of an intermediate load [bench: continuation_steps]
  core::Count continuation_few_cycles = 8;  ///< cycles up to which the next step is longer [bench: continuation_steps]
  core::Growth continuation_longer = 1.5;   ///< factor on the step after few cycles [bench: continuation_steps]
  core::Growth continuation_shortest_step =
      1.005;                                     ///< shortest step as a factor on the load [bench: continuation_steps]
  core::Positive continuation_coarseness = 1.6;  ///< cell of the continuation's grid over the resolving step
  core::Share first_load = 0.01;                 ///< first load over the scene's [bench: continuation_first_load]
  core::Positive lightest_M = 20.0;  ///< least M of the first load, as of a circle [bench: continuation_first_load]
  core::Growth next_first = 3.0;     ///< factor on a first load that is not solved
  core::Share heaviest_first = 0.5;  ///< heaviest first load over the scene's [bench: next_first]

  // Newton's method and passes (newton_fallback.cpp, passes.cpp)
  core::Count finest_from_hertz = 128;       ///< most cells of a start of Newton's method from the Hertz pressure
  core::Positive relief_over_film = 0.5;     ///< height of a relief over the film up to which surfaces may stay apart
  core::Positive boundary_film_start = 1.5;  ///< first boundary film over the oil film [bench: boundary_film_step]
  core::Growth boundary_film_step = 2.0;     ///< first factor between two boundary films [bench: boundary_film_step]
  core::Growth boundary_film_least_step = 1.05;    ///< least factor between them [bench: boundary_film_step]
  core::Positive tolerance_between_passes = 1e-9;  ///< relative residual of the passes before the last
  core::Positive chattering_residual = 2e-2;       ///< residual up to which a pass with chattering nodes counts

  // Domain (domain_error.cpp, accuracy.cpp, grid_keys.cpp)
  core::Positive error_of_closed_domain = 5e-5;  ///< allowed error of a chosen domain with the closed far field
  core::Share share_of_accuracy = 0.1;           ///< largest share of a required accuracy for a closed domain
  core::Positive closed_reach_of_line = 0.02;    ///< error of a line's closed far field over lambda/(Hc |X_a|^3)
  core::Positive closed_reach_of_oblique = 3.0;  ///< oblique ellipses [bench: closed_reach_of_oblique_contacts]
  core::Positive reach_of_thick_film = 8.0;  ///< domain of a thick film in sqrt(2 Hc), error 5e-5 [bench: closed_reach]
  core::Positive thick_film = 1.5;           ///< film over approach from which the outlet lies further downstream
  core::Positive most_at_inlet = 0.006;      ///< allowed error by the inlet, far field zero [bench: zero_domain]
  core::Positive most_at_inlet_of_line = 0.003;  ///< most_at_inlet of line contacts [bench: zero_domain]
  core::Positive most_of_load = 0.02;  ///< allowed error by the load outside, far field zero [bench: zero_domain]
  core::Positive wider_closed_domain = 1.25;  ///< half width over half length with the closed far field
  core::Positive domain_worth_a_look = 0.01;  ///< error of the domain that coarse solutions estimate, and a warning
  core::Count domain_fewest_cells = 32;       ///< least cells along x of these coarse solutions
  core::Share share_of_domain = 0.5;          ///< share of a required accuracy for the domain [bench: shares_of_domain]
  core::Share larger_share_of_domain = 0.7;   ///< share for the domain that is tried next [bench: shares_of_domain]
  core::Count most_coarse_cells = 1024;       ///< most cells along x of the solutions on larger domains
  core::Positive longest_domain = 200.0;      ///< longest domain in Hertz radii
  core::Positive longest_in_contacts = 72.0;  ///< longest domain over the size of the contact [bench: longest_domain]
  core::Share predicted_share = 0.95;         ///< predicted over allowed error of the next grid

  // Cells (grid_keys.cpp, resolution.cpp)
  core::Positive cells_on_circle = 48.0;        ///< least cells across the shorter axis of an oblique ellipse
  core::Positive cells_per_contact_size = 5.0;  ///< least cells per size of an oblique contact [bench: cells_on_circle]
  core::Positive too_steep = 2.0;               ///< change of the load within a/u_m that the closed far field follows
  core::Positive too_steep_for_ellipses = 0.5;  ///< too_steep of ellipses, if it is left open [bench: too_steep]

  core::Positive elongated_from = 6.0;   ///< length over width of a contact with stretched cells [bench: cell_aspect]
  core::Positive wide_from = 7.0;        ///< width over length of a contact with wide cells [bench: cell_aspect]
  core::Positive longest_cells = 16.0;   ///< most elongated cells [bench: cell_aspect]
  core::Positive resolving_share = 0.3;  ///< resolving cell over the film zone
  core::Positive resolving_size = 0.4;   ///< resolving cell over the shorter size [bench: resolving_share]
  core::Positive resolving_share_first_order = 0.2;  ///< resolving_share, first-order wedge [bench: resolving_share]
  core::Positive resolving_size_first_order = 0.2;   ///< resolving_size, first-order wedge [bench: resolving_share]

  // Error bars (error_bars.cpp, observed_errors.cpp, layer_error.cpp, relief.cpp)
  core::Share pressure_falls = 0.7;      ///< last change of a pressure over the one before if it converges
  core::Share pressure_at_rest = 1e-5;   ///< relative change that always counts as converged [bench: pressure_falls]
  core::Positive may_rise_by = 4.0;      ///< further growth of an unsettled spike over its last growth
  core::Positive order_of_P_max = 1.5;   ///< assumed order of convergence of P_max
  core::Share rim_without_spike = 0.85;  ///< pressure at the rim over the maximum without a spike [bench: solid_at_rim]
  core::Positive solid_at_rim = 12.0;    ///< ln eta_bar at the dry contact's rim from which a spike is expected
  core::Share dry_rim = 0.8;             ///< pressure at the dry contact's rim [bench: solid_at_rim]
  core::Share share_of_terms = 0.55;     ///< share of the adjoint estimate's terms in the error of Hc
  core::Share share_of_disagreement = 0.25;  ///< share of its disagreement with the grids, Hm [bench: share_of_terms]
  core::Share share_of_scattered = 0.1;      ///< share of a residual that changes its sign from node to node
  core::Positive next_order = 2.0;           ///< next order of the terms [bench: share_of_disagreement_extrapolated]
  core::Share share_of_disagreement_extrapolated = 0.17;  ///< share of the disagreement in an extrapolated Hc
  core::Share share_of_terms_extrapolated = 0.6;          ///< share of the terms in an extrapolated Hm
  core::Positive most_of_levels = 3.0;                    ///< largest adjoint estimate of Hm over that of the grids
  core::Positive order_of_Hc_of_line = 1.55;              ///< assumed order of convergence of Hc of lines
  core::Positive order_of_Hm_of_line = 1.05;              ///< assumed order of Hm of lines [bench: order_of_Hc_of_line]
  core::Positive safety_of_domain = 5.0;       ///< safety factor on the adjoint estimate of the domain's error
  core::Positive safety_of_closed_line = 3.0;  ///< safety factor on the rough estimate of a line's domain
  core::Positive order_of_observed = 1.5;      ///< assumed order of an integral over the film [bench: observed_errors]
  core::Positive slowest_order_of_observed = 0.32;  ///< lowest order of such an integral that is believed
  core::Positive order_of_two_levels = 1.0;         ///< order of an integral with two levels [bench: observed_errors]
  core::Positive least_observed = 3e-4;             ///< least error of an integral [bench: observed_errors]
  core::Positive least_of_two_levels = 2e-3;  ///< least error of an integral with two levels [bench: observed_errors]
  core::Positive growing_change = 1.1;        ///< growth of changes without an estimate [bench: observed_errors]
  core::Positive small_change = 1e-3;         ///< relative change that may grow [bench: observed_errors]
  core::Positive order_of_supply = 1.0;       ///< assumed order of convergence of a supply
  core::Positive least_supply_difference = 0.05;  ///< least difference of two supplies that gives a derivative
  core::Share relief_lost = 0.05;                 ///< largest share of the relief's variance lost on half as many cells
};
// clang-format on

/// Names and meanings of these numbers.
const std::vector<core::TunedNumber<Tuning>>& tuned_numbers();

}  // namespace ehl::steady
