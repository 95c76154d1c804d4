// Written by tests/structure/tuning.py from tuning.hpp.
#include "transient/tuning.hpp"

namespace ehl::transient {

const std::vector<core::TunedNumber<Tuning>>& tuned_numbers() {
  using core::Tunable;
  static const std::vector<core::TunedNumber<Tuning>> table{
      {"best_first_rate", Tunable::share, &Tuning::best_first_rate, "least factor of a first cycle"},
      {"best_rate", Tunable::share, &Tuning::best_rate, "least factor of later cycles"},
      {"worst_rate", Tunable::reduction, &Tuning::worst_rate, "convergence factor above which a cycle is in vain"},
      {"patience", Tunable::count, &Tuning::patience, "cycles in vain after which the step is cut"},
      {"strong_squeeze", Tunable::positive, &Tuning::strong_squeeze,
       "squeeze from which the load is corrected last only"},
      {"patience_of_newton", Tunable::count, &Tuning::patience_of_newton,
       "Newton steps in vain after which the step is cut"},
      {"most_by_newton", Tunable::count, &Tuning::most_by_newton, "most implicit steps by Newton's method in a row"},
      {"edge_reach", Tunable::count, &Tuning::edge_reach, "nodes that the edge of the film may move in a step"},
      {"zone_radius", Tunable::positive, &Tuning::zone_radius, "zone of the error norm in Hertz radii"},
      {"weight_outside", Tunable::share, &Tuning::weight_outside, "weight of nodes outside the zone"},
      {"weight_at_edge", Tunable::share, &Tuning::weight_at_edge, "further weight at the edge of the film"},
      {"least_yielding", Tunable::positive, &Tuning::least_yielding,
       "least central deformation in the load's correction"},
      {"longest_step", Tunable::positive, &Tuning::longest_step, "longest step in a/u_m: 20 from -a to a"},
      {"share_of_vibration", Tunable::share, &Tuning::share_of_vibration, "longest step over a free vibration"},
      {"first_step", Tunable::positive, &Tuning::first_step, "first step, and short steps after a jump"},
      {"after_checkpoint", Tunable::share, &Tuning::after_checkpoint, "first step after a checkpoint over the last"},
      {"micro_steps", Tunable::count, &Tuning::micro_steps, "number of the short steps after a jump"},
      {"least_bit", Tunable::share, &Tuning::least_bit, "least part of a jump in one increment"},
      {"unit_of_line", Tunable::positive, &Tuning::unit_of_line,
       "zero of the line kernel's logarithm in contact sizes"},
      {"far_squeeze_of_line", Tunable::positive, &Tuning::far_squeeze_of_line,
       "film that a relaxation displaces around a node"},
      {"settled_residual", Tunable::positive, &Tuning::settled_residual, "relative residual of a steady state"},
      {"hopeless_load_error", Tunable::positive, &Tuning::hopeless_load_error, "largest relative error of the load"},
      {"bit_of_start", Tunable::positive, &Tuning::bit_of_start, "increment of load and speed at the start"},
      {"cycles_per_bit", Tunable::count, &Tuning::cycles_per_bit, "cycles per increment of load and speed"},
      {"most_settling_cycles", Tunable::count, &Tuning::most_settling_cycles, "most cycles to the steady state"},
  };
  return table;
}

}  // namespace ehl::transient
