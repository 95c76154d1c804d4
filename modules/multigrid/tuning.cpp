// Written by tests/structure/tuning.py from tuning.hpp.
#include "multigrid/tuning.hpp"

namespace ehl::multigrid {

const std::vector<core::TunedNumber<Tuning>>& tuned_numbers() {
  using core::Tunable;
  static const std::vector<core::TunedNumber<Tuning>> table{
      {"y_sweep_crossover", Tunable::positive, &Tuning::y_sweep_crossover,
       "Y sweep: its crossover over that of the X sweep, per (hx/hy)^2"},
      {"y_sweep_damping", Tunable::share, &Tuning::y_sweep_damping, "Y sweep: damping"},
      {"y_sweep_damping_steep", Tunable::share, &Tuning::y_sweep_damping_steep,
       "Y sweep: further damping where epsilon is steep"},
      {"y_sweep_edge", Tunable::share, &Tuning::y_sweep_edge, "Y sweep: e_min/e_max below which epsilon is steep"},
      {"film_along_edge", Tunable::positive, &Tuning::film_along_edge,
       "film response at an edge on coarse grids, in K(0, 0)"},
      {"share_of_lines_beside", Tunable::share, &Tuning::share_of_lines_beside,
       "share of the derivatives of viscosity and epsilon by the lines beside"},
      {"elastic_coupling", Tunable::positive, &Tuning::elastic_coupling,
       "coupling by the elastic film, in epsilon/h^2"},
      {"coarse_film_floor", Tunable::share, &Tuning::coarse_film_floor,
       "least share of the finer film in a coarse epsilon"},
      {"fewest_lines", Tunable::count, &Tuning::fewest_lines, "least number of lines of a correcting grid"},
      {"coarsest_sweeps_per_cycle", Tunable::count, &Tuning::coarsest_sweeps_per_cycle,
       "least relaxations of the coarsest grid per cycle"},
      {"coarsest_cells", Tunable::positive, &Tuning::coarsest_cells, "cells along X that these solve"},
      {"coarsest_lines", Tunable::positive, &Tuning::coarsest_lines, "lines that these solve, stretched cells"},
      {"coarsest_raised", Tunable::positive, &Tuning::coarsest_raised,
       "growth of the residual in a visit that is repeated"},
      {"largest_fall", Tunable::share, &Tuning::largest_fall, "largest relative fall of the central film in a visit"},
      {"rough_factor", Tunable::share, &Tuning::rough_factor, "convergence factor above which a cycle is slow"},
      {"hopeless_residual", Tunable::positive, &Tuning::hopeless_residual,
       "relative residual that counts as divergence"},
      {"patience", Tunable::count, &Tuning::patience, "cycles in which the residual must fall"},
      {"hardly_less", Tunable::share, &Tuning::hardly_less, "factor by which the residual must fall in them"},
      {"poor_factor", Tunable::share, &Tuning::poor_factor, "convergence factor above which a cycle is poor"},
      {"back_off", Tunable::share, &Tuning::back_off,
       "factor on weights that are too large: the steep weight first, then all"},
      {"least_steep", Tunable::share, &Tuning::least_steep, "lower limit of the steep weight"},
      {"least_all", Tunable::share, &Tuning::least_all, "lower limit of all weights"},
      {"good_factor", Tunable::share, &Tuning::good_factor, "convergence factor that raises the steep weight"},
      {"growth_per_cycle", Tunable::positive, &Tuning::growth_per_cycle, "factor on the steep weight by a good cycle"},
      {"growth_limit", Tunable::positive, &Tuning::growth_limit, "upper limit of these factors together"},
      {"krylov_states", Tunable::count, &Tuning::krylov_states, "states of the Krylov acceleration"},
      {"meniscus_moves", Tunable::count, &Tuning::meniscus_moves, "first cycles, in which a meniscus may still move"},
      {"changes_of_chattering", Tunable::count, &Tuning::changes_of_chattering,
       "changes of kind after which a node chatters"},
      {"meniscus_residual", Tunable::positive, &Tuning::meniscus_residual,
       "residual below which a coarse meniscus has its place"},
      {"meniscus_cycles", Tunable::count, &Tuning::meniscus_cycles, "most cycles for its place, in extra_cycles"},
      {"cycles_per_supply", Tunable::count, &Tuning::cycles_per_supply, "cycles for each supply on the first grid"},
      {"next_supply", Tunable::reduction, &Tuning::next_supply, "next supply over the present one"},
      {"thinnest_supply", Tunable::share, &Tuning::thinnest_supply, "last supply over the flooded film"},
      {"balanced_oil", Tunable::positive, &Tuning::balanced_oil, "largest mass defect over the flow"},
      {"inlet_pressure", Tunable::positive, &Tuning::inlet_pressure, "pressure below which the inlet is corrected"},
      {"inlet_factor", Tunable::positive, &Tuning::inlet_factor, "first step of the factor on the inlet's pressure"},
      {"sweeps_per_balance", Tunable::count, &Tuning::sweeps_per_balance,
       "relaxations per correction of H00 at the start"},
      {"cycles_from_hertz", Tunable::count, &Tuning::cycles_from_hertz,
       "first cycles with epsilon as the mean of the nodes"},
      {"pressure_outside", Tunable::positive, &Tuning::pressure_outside,
       "largest initial pressure outside the contact"},
  };
  return table;
}

}  // namespace ehl::multigrid
